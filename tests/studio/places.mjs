// Where things lie; the environment says what the test's own place does not.
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const here = dirname(fileURLToPath(import.meta.url));
export const root = join(here, '../..');
export const web = join(root, 'tools/studio/web');
export const build = process.env.RIGSOUND_BUILD ?? join(root, 'build/release');
/** Where esbuild, playwright-core and axe-core lie. */
export const packages = join(build, 'tools/studio/web/packages');
export const rigsound = process.env.RIGSOUND ?? join(build, 'tools/rigsound');
export const rigsoundd = process.env.RIGSOUNDD ?? join(build, 'tools/rigsoundd');
/** Lets a call on a file fail, when it is loaded into a program. */
export const failingCalls = process.env.RIGSOUND_FAILING_CALLS ?? join(build, 'tests/cli/libfailing_calls.so');
export const pages = join(build, 'tools/studio/web');
export const output = join(build, 'tests/studio/output');
