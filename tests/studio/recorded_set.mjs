// A sound set of two banks whose recordings are at hand, as an engineer has it after Annotate and Analyse.
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { here, rigsound } from './places.mjs';
import { run } from './small_set.mjs';

export const recordedSet = () => {
  const folder = mkdtempSync(join(tmpdir(), 'rigsound_recorded.')), place = (...words) => join(folder, ...words), names = ['normal', 'overfeed'];
  mkdirSync(place('recordings'));
  names.forEach((name, n) => {
    run('python3', '-c', `import pathlib, sys; sys.path.insert(0, ${JSON.stringify(join(here, '../cli'))}); import studio_case; studio_case.write_recording(pathlib.Path(sys.argv[1]), 5, rate_hz=${24 + 6 * n}, seed=${n + 1})`,
      place('recordings', `${name}.wav`));
    writeFileSync(place('recordings', `${name}.txt`), `0.500000\t4.000000\t${name}\n`);
  });
  run(rigsound, 'analyze', ...names.map((name) => place('recordings', `${name}.wav`)), '--out', place('set'));
  return { folder, set: place('set'), recordings: place('recordings'), end: () => rmSync(folder, { recursive: true, force: true }) };
};
