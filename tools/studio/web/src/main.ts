// The studio's page: asks for the state of the sound set, then opens the first page or the one in the address.
import { h } from './dom/element';
import { failed } from './shell/states';
import { pages } from './page_list';
import type { State } from './server/documents';
import { askJson, ServerError } from './server/request';
import { Shell } from './shell/shell';

const start = async (): Promise<void> => {
  try {
    new Shell(pages, await askJson<State>('/state'));
  } catch (error) {
    const words = error instanceof ServerError && error.status === 401
      ? new Error('This address has no valid token. Open the one that rigsound studio printed when it started.') : error;
    document.body.replaceChildren(h('main', {}, failed(words, () => location.reload())));
  }
};
void start();
