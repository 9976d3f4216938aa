// The studio in a browser: fetches the text that the address asks for, and starts the studio with a worker beside it.
import start_module, { longest_text, refusal_of, start } from "./mech_page.js";

const told = document.querySelector("#told");
const canvas = document.querySelector("#studio");

/** What the user can read and do something about. */
class Trouble extends Error {}

/** Says something over the whole page, or below what is seen there. */
function tell(text) {
  told.classList.toggle("beside", !canvas.hidden);
  told.textContent = text;
}

/** The name of the file with a text: a Rust file, if a macro stands in it. */
function nameOf(text) {
  return /\bmechanism!\s*[{([]/.test(text) ? "shared.rs" : "shared.mech";
}

/** The text that somebody shares by an address. */
function shared(written) {
  try {
    return decodeURIComponent(written);
  } catch {
    const why = /%(?![0-9a-f]{2})/i.test(written)
      ? "a % in it lacks its two digits"
      : "what its % stand for is not UTF-8";
    throw new Trouble(`The shared text is not written as an address is: ${why}.`);
  }
}

/** The text of a file beside this page. */
async function fetched(name) {
  if (!/^[\w-]+\.(rs|mech)$/.test(name)) {
    throw new Trouble(`"${name}" is no name of a file: it has letters, digits, _ and -, and ends with .rs or .mech.`);
  }
  let answer;
  try {
    answer = await fetch(`mechanisms/${name}`);
  } catch (error) {
    throw new Trouble(`The mechanism "${name}" cannot be fetched: ${error.message}`);
  }
  if (!answer.ok) {
    throw new Trouble(`The mechanism "${name}" is not there: the server says ${answer.status}.`);
  }
  return await answer.text();
}

/** The text that the address asks for, with its name; without a name if it asks for none. */
async function wanted() {
  const written = /^#text=([^]*)/.exec(location.hash)?.[1];
  const name = new URLSearchParams(location.search).get("file");
  if (written === undefined && name === null) return { text: "" };
  const text = written === undefined ? await fetched(name) : shared(written);
  if (text.length > longest_text()) {
    throw new Trouble(`The text has ${text.length} characters; the studio opens ${longest_text()} at most.`);
  }
  return { name: name ?? nameOf(text), text };
}

/** Shows what is wrong instead of what does not run. */
function checkBrowser() {
  if (typeof WebAssembly !== "object") {
    throw new Trouble("The studio needs WebAssembly, which this browser does not have or does not allow.");
  }
  // Another canvas: this one is the studio's alone.
  const probe = document.createElement("canvas");
  const webgl = probe.getContext("webgl2") ?? probe.getContext("webgl");
  if (!webgl) {
    throw new Trouble("The studio draws by WebGL, which this browser does not have or does not allow.");
  }
  webgl.getExtension("WEBGL_lose_context")?.loseContext();
}

/** The program, compiled once for the page and its worker. */
async function compiled() {
  const answer = await fetch("mech_page_bg.wasm");
  if (!answer.ok) throw new Trouble(`The studio is not there: the server says ${answer.status}.`);
  return await WebAssembly.compile(await answer.arrayBuffer());
}

/** The worker that analyses, so that the page never waits. Another takes its place when it is ended, or breaks. */
class Analysis {
  constructor(module) {
    this.module = module;
    this.early = [];
    this.begin();
  }

  begin() {
    const worker = new Worker("worker.js", { type: "module" });
    this.worker = worker;
    this.isReady = false;
    worker.onmessage = ({ data }) => {
      if (worker !== this.worker) return;
      this.isReady = true;
      if (data.reply) this.hear(data.reply);
      if (data.broken) this.lose(data.broken);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      if (worker === this.worker) this.lose(event.message ?? "it does not start");
    };
    worker.postMessage(this.module);
  }

  post = (call) => {
    if (this.worker === undefined) throw new Error("it does not start");
    this.worker.postMessage(call, [call.buffer]);
  };

  restart = () => {
    // One that never started will not start the next time either.
    if (this.worker === undefined) throw new Error("it does not start");
    this.worker.terminate();
    this.begin();
  };

  /** Passes on what the worker tells, as soon as there is a studio that hears it. */
  hear(reply) {
    if (this.running) this.running.hear(reply);
    else this.early.push(reply);
  }

  lose(why) {
    if (!this.isReady) this.worker = undefined;
    this.running?.lose_worker(why);
  }

  serve(running) {
    this.running = running;
    for (const reply of this.early.splice(0)) running.hear(reply);
  }
}

/** Says it when the studio breaks, in the same words whatever broke. */
function watch(running) {
  const broke = (why) => {
    clearInterval(timer);
    tell(`The studio broke, which is a mistake of its own: ${why}\nLoad the page again to go on.`);
  };
  const timer = setInterval(() => {
    try {
      const panic = running.panic();
      if (panic !== undefined) broke(panic);
    } catch (error) {
      broke(error.message ?? error);
    }
  }, 1000);
  addEventListener("error", (event) => broke(running.panic() ?? event.message));
  addEventListener("unhandledrejection", (event) => broke(event.reason?.message ?? event.reason));
  canvas.addEventListener("webglcontextlost", () => broke("the browser took its canvas away"));
}

/** Lets the browser ask before work is lost. What was typed just now is work, too: the studio has not seen it yet. */
function keepWork(running) {
  let typed = -Infinity;
  for (const kind of ["keydown", "input", "pointerup"]) {
    addEventListener(kind, () => (typed = performance.now()), { capture: true });
  }
  addEventListener("beforeunload", (event) => {
    if (running.has_work() || performance.now() - typed < 300) event.preventDefault();
  });
}

/** Hands the file that the user has chosen to the studio. */
function takeFiles(running) {
  const chooser = document.getElementById("file");
  chooser.addEventListener("change", async () => {
    const file = chooser.files[0];
    if (file === undefined) return;
    const why = refusal_of(file.name, file.size);
    if (why !== undefined) {
      running.refuse(why);
    } else {
      running.take(file.name, new Uint8Array(await file.arrayBuffer()));
    }
    // The same file may be chosen again.
    chooser.value = "";
    canvas.focus();
  });
}

tell("The studio is loading.");
try {
  checkBrowser();
  const module = await compiled();
  await start_module({ module_or_path: module });
  const analysis = new Analysis(module);
  const { name, text } = await wanted();
  canvas.hidden = false;
  const running = await start(canvas, name, text, analysis.post, analysis.restart);
  analysis.serve(running);
  told.textContent = "";
  canvas.focus();
  takeFiles(running);
  keepWork(running);
  watch(running);
} catch (error) {
  canvas.hidden = true;
  tell(error instanceof Trouble ? error.message : `The studio does not start: ${error?.message ?? error}`);
}

// Another text that is shared is another address of the same page.
addEventListener("hashchange", () => location.reload());
