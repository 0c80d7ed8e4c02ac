// build.mjs OUT ENGINE.wasm: the page's files in folder OUT, and export.html, the Rig page as one file. Takes esbuild from the
// node_modules of the current folder.
import { createHash } from 'node:crypto';
import { copyFile, mkdir, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [out, engine] = process.argv.slice(2);
if (!engine) {
  console.error('usage: node build.mjs OUT ENGINE.wasm');
  process.exit(2);
}
const esbuild = createRequire(join(process.cwd(), 'package.json'))('esbuild');
const source = join(dirname(fileURLToPath(import.meta.url)), 'src');
const common = { bundle: true, minify: true, target: 'es2021', legalComments: 'none', logLevel: 'warning' };

const bundled = async (entry, options = {}) => {
  const result = await esbuild.build({ ...common, entryPoints: [join(source, entry)], write: false, ...options });
  return result.outputFiles[0].text;
};

const digest = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
// What stands inside a script element must not end it.
const inline = (text) => text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

// `rigsound studio --export` puts engine, packed set and rig in the place of the three words in capitals.
const exportPage = (script, style, worklet) => {
  const policy = `default-src 'none'; script-src ${digest(script)} 'wasm-unsafe-eval' data:; worker-src data:; ` +
    `style-src ${digest(style)}; img-src data:; base-uri 'none'; form-action 'none'`;
  const data = (id, content) => `<script type="text/plain" id="${id}">${content}</script>\n`;
  return `<!doctype html>\n<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1"><title>rigsound</title><link rel="icon" href="data:,">
<style>${style}</style></head><body>
${data('worklet', Buffer.from(worklet).toString('base64'))}${data('engine', 'RIGSOUND_ENGINE')}` +
    `${data('sound-set', 'RIGSOUND_RIGSET')}${data('rig', 'RIGSOUND_RIG_JSON')}` +
    `<script>${script}</script>\n</body></html>\n`;
};

await mkdir(out, { recursive: true });
const style = await bundled('style/app.css');
const worklet = await bundled('audio/worklet.ts', { format: 'iife' });
await writeFile(join(out, 'app.js'), await bundled('main.ts', { format: 'esm' }));
await writeFile(join(out, 'app.css'), style);
await writeFile(join(out, 'worklet.js'), worklet);
await copyFile(join(source, 'index.html'), join(out, 'index.html'));
await copyFile(engine, join(out, 'engine.wasm'));
const script = inline(await bundled('export_main.ts', { format: 'iife' }));
await writeFile(join(out, 'export.html'), exportPage(script, style, worklet));
