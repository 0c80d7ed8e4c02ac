// The program itself: `rigsound studio` on folders of the test's own.
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { pages, rigsound } from './places.mjs';

/** Resolves once it has said its address. */
export const startStudio = (set, ...options) => startStudioIn({}, set, ...options);

/** The same with variables of the environment. */
export const startStudioIn = async (environment, set, ...options) => {
  const program = spawn(rigsound, ['studio', set, '--pages', pages, ...options], { stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, ...environment } });
  let said = '';
  program.stderr.on('data', (text) => { said += text; });
  const address = await new Promise((done, failed) => {
    createInterface({ input: program.stdout }).once('line', done);
    program.once('exit', (code) => failed(new Error(`rigsound studio ended with ${code}: ${said}`)));
  });
  return { address, program, said: () => said, stop: () => new Promise((done) => { program.once('exit', done); program.kill('SIGTERM'); }),
    kill: () => new Promise((done) => { program.once('exit', done); program.kill('SIGKILL'); }) };
};
