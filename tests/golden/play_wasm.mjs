// play_wasm.mjs ENGINE.wasm: what the module imports and exports, as JSON.
// play_wasm.mjs ENGINE.wasm SET.rigset CHANGES.csv BLOCKS: SHA-256 of the floats it plays, and what it says of itself.
// A line of CHANGES: block from which on, "set" or "control", name, boom, value.
import crypto from 'crypto';
import fs from 'fs';

const [file, set, changes, blocks] = process.argv.slice(2);
const module = new WebAssembly.Module(fs.readFileSync(file));
if (!set) {
  console.log(JSON.stringify({ imports: WebAssembly.Module.imports(module), exports: WebAssembly.Module.exports(module) }));
  process.exit();
}
const ended = (code) => { throw new Error('the module ended with ' + code); };
const engine = new WebAssembly.Instance(module, {
  env: { emscripten_notify_memory_growth() {} }, wasi_snapshot_preview1: { proc_exit: ended } }).exports;
engine._initialize();

const put = (bytes) => {
  const at = engine.malloc(bytes.length);
  new Uint8Array(engine.memory.buffer).set(bytes, at);
  return at;
};
const text = (at) => {
  const bytes = new Uint8Array(engine.memory.buffer);
  return Buffer.from(bytes.subarray(at, bytes.indexOf(0, at))).toString();
};
const opened = (bytes) => {
  const at = put(bytes);
  const rig = engine.rigsound_open_memory(at, bytes.length);
  engine.free(at);
  return rig;
};

const bytes = fs.readFileSync(set);
// What is thrown inside stops at the interface.
if (opened(bytes.subarray(0, bytes.length - 1)) !== 0) throw new Error('a set that is cut off was opened');
const refused = text(engine.rigsound_last_error(0));
const rig = opened(bytes);
if (rig === 0) throw new Error(text(engine.rigsound_last_error(0)));

const lines = fs.readFileSync(changes, 'utf8').trim().split('\n').map((line) => line.split(','));
const size = engine.rigsound_block(rig) * engine.rigsound_channels(rig) * 4;
const block = engine.malloc(size);
const hash = crypto.createHash('sha256');
let next = 0;
for (let n = 0; n < Number(blocks); ++n) {
  for (; next < lines.length && Number(lines[next][0]) <= n; ++next) {
    const [, call, name, boom, value] = lines[next];
    const at = put(Buffer.from(name + '\0'));
    if (engine['rigsound_' + call](rig, at, Number(boom), Number(value)) !== 0)
      throw new Error(text(engine.rigsound_last_error(rig)));
    engine.free(at);
  }
  engine.rigsound_process(rig, block);
  hash.update(new Uint8Array(engine.memory.buffer, block, size));
}
console.log(JSON.stringify({ sha256: hash.digest('hex'), refused, version: text(engine.rigsound_version()) }));
