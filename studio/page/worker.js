// Analyses beside the page: takes tasks, and does them piece by piece, so that a newer task can take the place of an older one between two.
import start_module, { Analyst, broken } from "./mech_page.js";

let analyst;
const early = [];
const turn = new MessageChannel();

/** Does something, and tells the page if it breaks. */
function guarded(act) {
  try {
    act();
  } catch (error) {
    analyst = undefined;
    postMessage({ broken: broken() ?? error.message ?? String(error) });
  }
}

function tell(reply) {
  if (reply !== undefined) postMessage({ reply }, [reply.buffer]);
}

function take(call) {
  tell(analyst.take(call));
  turn.port2.postMessage(undefined);
}

/** Does a piece. What comes meanwhile is heard before the next one. */
turn.port1.onmessage = () => {
  if (analyst === undefined) return;
  guarded(() => {
    const begun = analyst.begin();
    if (begun === undefined) return;
    tell(begun);
    analyst.go_on().forEach(tell);
    turn.port2.postMessage(undefined);
  });
};

onmessage = async ({ data }) => {
  if (data instanceof WebAssembly.Module) {
    await start_module({ module_or_path: data });
    analyst = new Analyst();
    postMessage({});
    guarded(() => early.splice(0).forEach(take));
  } else if (analyst === undefined) {
    early.push(data);
  } else {
    guarded(() => take(data));
  }
};
