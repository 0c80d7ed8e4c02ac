// wasm_share.mjs ENGINE.wasm SET.rigset CHANGES.csv: what share of a core a minute of the set takes, as JSON. The lines of
// CHANGES are those of tests/golden/play_wasm.mjs. The first ten seconds, in which node still compiles, do not count.
import fs from 'fs';

const [file, set, changes] = process.argv.slice(2);
const engine = new WebAssembly.Instance(new WebAssembly.Module(fs.readFileSync(file)), {
  env: { emscripten_notify_memory_growth() {} },
  wasi_snapshot_preview1: { proc_exit(code) { throw new Error('the module ended with ' + code); } } }).exports;
engine._initialize();

const put = (bytes) => {
  const at = engine.malloc(bytes.length);
  new Uint8Array(engine.memory.buffer).set(bytes, at);
  return at;
};
const bytes = fs.readFileSync(set);
const rig = engine.rigsound_open_memory(put(bytes), bytes.length);
if (rig === 0) throw new Error(set + ' cannot be opened');
const lines = fs.readFileSync(changes, 'utf8').trim().split('\n').map((line) => line.split(','));
const calls = lines.map(([at, call, name, boom, value]) =>
  [Number(at), engine['rigsound_' + call], put(Buffer.from(name + '\0')), Number(boom), Number(value)]);

const rate = engine.rigsound_rate(rig), frames = engine.rigsound_block(rig);
const block = engine.malloc(frames * engine.rigsound_channels(rig) * 4);
const blocks = Math.floor(60 * rate / frames), from = Math.floor(10 * rate / frames);
let next = 0, start;
for (let n = 0; n < blocks; ++n) {
  if (n === from) start = process.cpuUsage();
  for (; next < calls.length && calls[next][0] <= n; ++next) calls[next][1](rig, ...calls[next].slice(2));
  engine.rigsound_process(rig, block);
}
const spent = process.cpuUsage(start), us = (spent.user + spent.system) / (blocks - from);
console.log(JSON.stringify({ us, share: us * 1e-6 * rate / frames }));
