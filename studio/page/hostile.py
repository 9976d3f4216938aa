"""Texts and files that would freeze or break the studio's page if it waited for them, or had no limits."""

FOUR_BAR = """link crank; link coupler; link rocker;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, coupler) at (0, 1);
joint c = revolute(coupler, rocker) at (3, 2);
joint d = revolute(rocker, ground) at (3, 0);
motor a;
"""

LEGS = """struct Walker;
part Leg(phase = 0 deg) {
  port frame { point hip = (4, 0.5); } port crank { point pin = (1, 0) turned phase; }
  link coupler { point pin = (0, 0); point knee = (3.2, 0); point foot = (5, -1); }
  link rocker { point hip = (0, 0); point knee = (0, 2.5); }
  joint pin = revolute(crank.pin, coupler.pin); joint knee = revolute(coupler.knee, rocker.knee);
  joint hip = revolute(frame.hip, rocker.hip); start { rocker near 0 deg; }
}
ground { point shaft = (0, 0); } link axle { point shaft = (0, 0); }
joint main = revolute(ground.shaft, axle.shaft); motor main;
use leg[COUNT]: Leg(phase = k * TURN deg) { frame = ground, crank = axle };
"""


def legs(count):
    return LEGS.replace("COUNT", str(count)).replace("TURN", str(360 / count))


def scissors(count):
    """Lazy tongs of so many crossed bars, pushed at their foot."""
    text = "struct Scissors;\n"
    for number in range(count):
        at = 2 * number
        text += f"link l{number}; link r{number}; joint m{number} = revolute(l{number}, r{number}) at (1, {at + 1});\n"
        if number:
            text += f"joint p{number} = revolute(l{number - 1}, r{number}) at (2, {at});\n"
            text += f"joint q{number} = revolute(r{number - 1}, l{number}) at (0, {at});\n"
    return text + (
        "link slider; joint foot = revolute(ground, l0) at (0, 0); joint shoe = revolute(slider, r0) at (2, 0);\n"
        "joint rail = prismatic(ground, slider) at (2, 0) along 0 deg; motor rail;\n"
    )


def chain(count):
    """So many dyads, each driven by the one before."""
    text = "struct Chain;\nlink r0; joint d0 = revolute(ground, r0) at (0, 0); motor d0;\n"
    for n in range(1, count + 1):
        text += f"link k{n}; link r{n}; joint b{n} = revolute(r{n - 1}, k{n}) at ({3 * n - 3}, 1);\n"
        text += f"joint c{n} = revolute(k{n}, r{n}) at ({3 * n}, 2); joint d{n} = revolute(r{n}, ground) at ({3 * n}, 0);\n"
    return text


def many(statement, count):
    return "struct Many; " + "".join(statement.replace("#", str(n)) for n in range(count))


def texts():
    """All hostile texts, each with its name."""
    brackets = "struct Deep; link a { point p = (%s1%s, 0); }"
    for depth in 200, 11_000, 20_000, 100_000:
        yield f"brackets {depth}", brackets % ("(" * depth, ")" * depth)
        yield f"brackets without end {depth}", "struct Deep; " + "(" * depth
    for count in 1_000, 20_000, 200_000:
        yield f"semicolons {count}", "struct Many;" + ";" * count
        yield f"digits {count}", f"struct Long; link a {{ point p = ({'9' * count}, 0); }}"
        yield f"minus {count}", f"struct Long; const C = {'-' * count}1; {FOUR_BAR}"
        yield f"terms {count}", f"struct Long; const C = 1{'+1' * count}; {FOUR_BAR}"
        yield f"a name {count}", f"struct Long; link {'a' * count}; {FOUR_BAR}"
        yield f"a line {count}", f"struct Long; {FOUR_BAR} // {'x' * count}"
    for count in 100, 1_000, 3_000, 10_000:
        yield f"empty links {count}", many("link a#;", count)
        yield f"unknown joints {count}", "struct Many; " + FOUR_BAR + "".join(f"motor z{n};" for n in range(count))
        yield f"one name {count}", "struct Many; " + FOUR_BAR + "link crank;" * count
        yield f"turning links {count}", many("link a#; joint j# = revolute(ground, a#) at (0, 0); motor j#;", count)
        yield f"sliding links {count}", many("link a#; joint j# = prismatic(ground, a#) at (0, #) along 0 deg;", count)
        yield f"points {count}", "struct Many; " + FOUR_BAR.replace(
            "link coupler;", "link coupler { " + "".join(f"point p{n} = ({n}, 1); " for n in range(count)) + "}"
        )
    for count in 10, 40, 150:
        yield f"scissors {count}", scissors(count)
    for count in 50, 200, 600:
        yield f"chain {count}", chain(count)
    for count in 50, 250, 1_000, 100_000, 4_294_967_295:
        yield f"legs {count}", legs(count)
    for depth in 8, 12, 30:
        parts = "part P0() { port f { point a = (0, 0); } link x { point a = (0, 0); } joint j = revolute(f.a, x.a); } "
        for n in range(1, depth):
            parts += f"part P{n}() {{ port f {{ point a = (0, 0); }} use u: P{n - 1}() {{ f = f }}; use v: P{n - 1}() {{ f = f }}; }} "
        yield f"parts of parts {depth}", (
            f"struct Nested; {parts} ground {{ point a = (0, 0); }} use w: P{depth - 1}() {{ f = ground }};"
        )
    for count in 300, 3_000:
        yield f"constants {count}", "struct Many; const C0 = 1;" + "".join(
            f"const C{n + 1} = C{n} + C{n};" for n in range(count)
        )
        yield f"gears {count}", many("link g#; joint j# = revolute(ground, g#) at (#, 0);", count) + "".join(
            f"joint m{n} = gear(g{n}, g{n + 1}, 20 : 20);" for n in range(count - 1)
        ) + "motor j0;"
        yield f"welds {count}", "struct Many; " + FOUR_BAR + "link w0; joint q0 = weld(crank, w0) at (0, 0);" + "".join(
            f"link w{n + 1}; joint q{n + 1} = weld(w{n}, w{n + 1}) at (0, {n});" for n in range(count)
        )
        yield f"circles {count}", "struct Many; " + FOUR_BAR.replace(
            "link coupler;", "link coupler { " + "".join(f"circle ({n}, 1) radius 1; " for n in range(count)) + "}"
        )
        yield f"mechanisms {count}", "".join(f"mechanism! {{ struct A{n}; {FOUR_BAR} }}\n" for n in range(count))
        yield f"lines {count}", "struct Many;" + "\n" * count * 100 + FOUR_BAR
        yield f"comments in one another {count}", "struct Many; " + "/*" * count + "*/" * count + FOUR_BAR
        yield f"attributes {count}", "#[a]" * count + "struct Many; " + FOUR_BAR
        yield f"marks on one letter {count}", f"struct Many; // a{chr(0x301) * count}\n{FOUR_BAR}"
        yield f"quoted letters {count}", f'struct Many; "{chr(0x1F600) * count}" {FOUR_BAR}'
    for letter in "\x00", "\u202e", "\ufeff", "'", '"', "/*", "\\":
        yield f"letters {letter!r}", f"struct Odd; {letter * 5000} {FOUR_BAR}"


def files():
    """All hostile files, each with its name."""
    yield "slashes.mech", b"/" * (20 << 20)
    yield "line.mech", b"struct A; // " + b"x" * 10**7
    yield "noise.mech", bytes(range(256)) * 4000
    yield "noise.png", b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 400
    yield "large.jpg", b"\xff\xd8" + b"\x00" * (40 << 20)
    yield "noise.linkage2", b"<linkage2>" * 90_000
