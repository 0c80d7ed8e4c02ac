// A small sound set, its rig, and what is packed of both, in a folder of its own.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { here, rigsound } from './places.mjs';

export const run = (...words) => execFileSync(words[0], words.slice(1), { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

export const smallSet = () => {
  const folder = mkdtempSync(join(tmpdir(), 'rigsound_studio.'));
  run('python3', '-c', `import sys; sys.path.insert(0, ${JSON.stringify(join(here, '../cli'))}); import sound_set; sound_set.write_sound_set(sys.argv[1])`, join(folder, 'sounds'));
  writeFileSync(join(folder, 'rig.toml'), '[audio]\nrate = 48000\nblock = 64\n[sound]\nset = "sounds"\nseed = 11\n');
  run(rigsound, 'pack', join(folder, 'sounds'), join(folder, 'packed.rigset'), '--rig', join(folder, 'rig.toml'));
  return { folder, packed: readFileSync(join(folder, 'packed.rigset')), rig: join(folder, 'rig.toml'), end: () => rmSync(folder, { recursive: true, force: true }) };
};
