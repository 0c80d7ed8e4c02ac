// The frame around every page: navigation, status line, what is offline.
import { watchOutput } from '../audio/output';
import { h } from '../dom/element';
import { button } from '../dom/fields';
import type { State } from '../server/documents';
import { askJson, watchConnection, type Connection } from '../server/request';
import type { Opened, Page } from './page';
import { Shortcuts } from './shortcuts';
import { failed, loading } from './states';

const kRetryEvery_ms = 2000;

export class Shell {
  private readonly main = h('main', { id: 'main', tabindex: -1 });
  private readonly said = h('span', { role: 'status' });
  private readonly shortcuts: Shortcuts;
  private readonly links = new Map<string, HTMLAnchorElement>();
  private opened: Opened | null = null;
  private turn = 0;
  private here = '';
  private retrying = 0;

  constructor(private readonly pages: Page[], state: State) {
    const navigation = h('nav', { 'aria-label': 'Pages' },
      h('div', { class: 'brand' }, 'rigsound studio', h('small', { title: state.sound_set.name }, state.sound_set.name)));
    pages.forEach((page, n) => {
      const link = h('a', { href: `#/${page.id}` }, page.title, h('kbd', { 'aria-hidden': 'true' }, n + 1));
      this.links.set(page.id, link);
      navigation.append(link);
    });
    navigation.append(h('div', { class: 'foot' }, button('Keys', () => this.shortcuts.show(), { 'aria-keyshortcuts': '?' })));
    this.shortcuts = new Shortcuts(pages.map((page, n) => ({ key: String(n + 1), does: page.title, run: () => { location.hash = `#/${page.id}`; } })));
    document.body.replaceChildren(h('a', { class: 'skip', href: '#main', on: { click: (event) => { event.preventDefault(); this.main.focus(); } } }, 'To the page'),
      h('div', { class: 'studio' }, navigation, this.main, this.statusLine(state)));
    addEventListener('hashchange', () => void this.follow());
    addEventListener('beforeunload', (event) => { if (this.opened?.unsaved?.()) event.preventDefault(); });
    watchConnection((connection) => this.showConnection(connection));
    void this.follow();
  }

  private statusLine(state: State): HTMLElement {
    const audio = h('span', {}, 'No sound yet');
    watchOutput((context) => {
      audio.textContent = context.state === 'running'
        ? `Sound: ${context.sampleRate / 1000} kHz, ${Math.round(1000 * (context.baseLatency + (context.outputLatency || 0)))} ms to the card`
        : 'Sound: waiting for a key or a click';
    });
    return h('footer', { class: 'status' }, audio, this.said, h('span', {}, `rigsound ${state.version}`));
  }

  private showConnection(connection: Connection): void {
    clearTimeout(this.retrying);
    document.querySelector('.banner')?.remove();
    if (connection === 'here') return;
    document.body.prepend(h('div', { class: 'banner', role: 'alert' }, connection === 'gone'
      ? `The studio program has ended or does not answer. Nothing here is lost: start it again with --port ${location.port}, and put the address that it prints into this tab.`
      : 'The studio program was started anew. Nothing here is lost: put the address that it printed into this tab.'));
    const retry = (): void => { askJson('/state').catch(() => { this.retrying = setTimeout(retry, kRetryEvery_ms); }); };
    this.retrying = setTimeout(retry, kRetryEvery_ms);
  }

  private async follow(): Promise<void> {
    const page = this.pages.find(({ id }) => location.hash.startsWith(`#/${id}`)) ?? this.pages[0];
    if (!page || (page.id === this.here && this.opened)) return;
    const lost = this.opened?.unsaved?.();
    if (lost && !confirm(`${lost} Leave all the same?`)) {
      location.hash = `#/${this.here}`;
      return;
    }
    const turn = ++this.turn;
    this.opened?.close();
    this.opened = null;
    this.here = page.id;
    this.shortcuts.ofPage([]);
    this.links.forEach((link, id) => (id === page.id ? link.setAttribute('aria-current', 'page') : link.removeAttribute('aria-current')));
    document.title = `${page.title} · rigsound studio`;
    const tools = h('div', { class: 'tools' }), place = h('div', { class: 'stack' }, loading('Opening'));
    this.main.replaceChildren(h('header', {}, h('h1', {}, page.title), h('p', {}, page.about), tools), place);
    try {
      const opened = await page.open(place, tools, await askJson<State>('/state'));
      if (turn !== this.turn) return opened.close();
      this.opened = opened;
      this.shortcuts.ofPage(opened.shortcuts ?? []);
    } catch (error) {
      if (turn === this.turn) place.replaceChildren(failed(error, () => { this.here = ''; void this.follow(); }));
    }
  }
}
