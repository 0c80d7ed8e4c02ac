// How the page asks its server: the token in a header, errors as the server's own line, and whether it is there at all.

const kRoot = '/api/v1';
const kTokenKey = 'rigsound-token';

export class ServerError extends Error {
  constructor(readonly status: number, line: string, readonly answer: Record<string, unknown> = {}) { super(line); }
}

/** The server did not answer. */
export class Offline extends Error {
  constructor() { super('The studio does not answer.'); }
}

/** The token of the address the program printed; kept for this tab, and gone from the address bar. */
const readToken = (shownNext: string): string => {
  const given = /^#([A-Za-z0-9_-]{16,})$/.exec(location.hash)?.[1];
  if (given) {
    sessionStorage.setItem(kTokenKey, given);
    history.replaceState(null, '', location.pathname + shownNext);
  }
  return sessionStorage.getItem(kTokenKey) ?? '';
};
let token = readToken('');
// A program that was started anew has another token: its address, put into this tab, brings it to the page as it is. This
// listener comes before those that follow the address.
addEventListener('hashchange', (event) => { token = readToken(new URL(event.oldURL).hash); });

/** `here`: the server answers; `gone`: nobody does; `stranger`: one that was started anew and does not know this page. */
export type Connection = 'here' | 'gone' | 'stranger';
let connection: Connection = 'here';
const watchers = new Set<(connection: Connection) => void>();
export const watchConnection = (watcher: (connection: Connection) => void): void => { watchers.add(watcher); };
const report = (state: Connection): void => {
  if (connection !== state) watchers.forEach((watcher) => watcher(state));
  connection = state;
};

export interface Ask { method?: string; body?: unknown; signal?: AbortSignal }

/** Rejects with ServerError, with Offline, or as the signal does. */
export const ask = async (path: string, { method = 'GET', body, signal }: Ask = {}): Promise<Response> => {
  let response: Response;
  try {
    response = await fetch(kRoot + path, {
      method, headers: { 'X-Rigsound-Token': token, ...(body === undefined ? {} : { 'Content-Type': 'application/json' }) },
      ...(body === undefined ? {} : { body: JSON.stringify(body) }), ...(signal ? { signal } : {}) });
  } catch (error) {
    if (signal?.aborted) throw error;
    report('gone');
    throw new Offline();
  }
  report(response.status === 401 ? 'stranger' : 'here');
  if (response.ok) return response;
  const answer = await response.json().catch(() => ({})) as Record<string, unknown>;
  throw new ServerError(response.status, String(answer.error ?? `${response.status} ${response.statusText}`), answer);
};

export const askJson = async <T>(path: string, options: Ask = {}): Promise<T> => (await ask(path, options)).json() as Promise<T>;
export const askBytes = async (path: string, options: Ask = {}): Promise<Uint8Array> =>
  new Uint8Array(await (await ask(path, options)).arrayBuffer());

/** Every line of a stream of JSON lines, until it ends. */
export async function* askLines<T>(path: string, signal: AbortSignal): AsyncGenerator<T> {
  const reader = (await ask(path, { signal })).body?.getReader(), decoder = new TextDecoder();
  let rest = '';
  while (reader) {
    const { done, value } = await reader.read();
    if (done) return;
    const lines = (rest + decoder.decode(value, { stream: true })).split('\n');
    rest = lines.pop() ?? '';
    for (const line of lines) if (line) yield JSON.parse(line) as T;
  }
}
