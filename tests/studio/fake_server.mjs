// A server of the studio's pages whose answers a test gives, for states that the program shows only when something is wrong
// or slow. Speaks tools/studio/server/API.md.
import { readFile } from 'node:fs/promises';
import http from 'node:http';
import { join, normalize } from 'node:path';

const kTypes = { html: 'text/html; charset=utf-8', js: 'text/javascript; charset=utf-8', css: 'text/css; charset=utf-8', wasm: 'application/wasm' };
const kPolicy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:; media-src blob:; " +
  "connect-src 'self'; worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
export const kToken = '0123456789abcdef0123456789abcdef';

const bodyOf = async (request) => {
  const parts = [];
  for await (const part of request) parts.push(part);
  return Buffer.concat(parts).toString();
};

/** `routes`: {'GET /state': answer}, where an answer is an object (JSON), octets, or a function of {query, body, path, response}
 *  that gives one, or {status, json}. The longest key that begins the path serves it. `files`: scripts of the test's own. */
export const fakeServer = async (pages, routes, files = {}) => {
  const asked = [];
  const server = http.createServer(async (request, response) => {
    const url = new URL(request.url, 'http://127.0.0.1');
    const send = (status, type, content) => {
      response.writeHead(status, { 'Content-Type': type, 'Content-Security-Policy': kPolicy, 'Cache-Control': 'no-store', 'X-Rigsound-Exact': '1' });
      response.end(content);
    };
    if (!url.pathname.startsWith('/api/v1/')) {
      const file = normalize(url.pathname === '/' ? '/index.html' : url.pathname);
      if (files[file]) return send(200, kTypes.js, files[file]);
      return readFile(join(pages, file)).then((text) => send(200, kTypes[file.split('.').pop()] ?? 'text/plain', text), () => send(404, 'text/plain', ''));
    }
    const path = url.pathname.slice('/api/v1'.length), body = await bodyOf(request);
    asked.push({ method: request.method, path, query: url.search, body });
    if (request.headers['x-rigsound-token'] !== kToken) return send(401, 'application/json', '{"error": "token: missing"}');
    const key = Object.keys(routes).filter((each) => each.split(' ')[0] === request.method && path.startsWith(each.split(' ')[1]))
      .sort((a, b) => b.length - a.length)[0];
    if (key === undefined) return send(404, 'application/json', JSON.stringify({ error: `${path}: there is none` }));
    let answer = routes[key];
    if (typeof answer === 'function') answer = await answer({ path, query: url.searchParams, body: body && JSON.parse(body), response });
    if (answer === undefined) return;
    if (answer instanceof Uint8Array) return send(200, 'application/octet-stream', answer);
    if (answer.status) return send(answer.status, 'application/json', JSON.stringify(answer.json));
    send(200, 'application/json', JSON.stringify(answer));
  });
  const listen = (port) => new Promise((done) => server.listen(port, '127.0.0.1', done));
  await listen(0);
  const { port } = server.address();
  const stop = () => new Promise((done) => { server.close(done); server.closeAllConnections(); });
  return { address: `http://127.0.0.1:${port}/#${kToken}`, asked, routes, stop, start: () => listen(port) };
};
