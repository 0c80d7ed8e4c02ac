// Analyse: the chain over chosen parts of recordings, with what it finds as soon as it has found it.
import { noRecordings } from '../annotate/annotate_page';
import { readTrack } from '../annotate/label_track';
import { partWords, type Part } from '../annotate/part';
import type { Bank } from '../bank/bank_document';
import { bankFacts } from '../bank/bank_facts';
import { bankPlots } from '../bank/bank_plots';
import { h } from '../dom/element';
import { button, choice, number, pick, tick } from '../dom/fields';
import { clock, shown } from '../dom/number_text';
import { progressRow } from '../dom/progress_row';
import type { Recording } from '../server/documents';
import { ended, followJob, startJob, stopJob, type Job } from '../server/jobs';
import { askJson } from '../server/request';
import type { Page } from '../shell/page';
import { failed, loading } from '../shell/states';

interface MadeBank { bank: string; situation: string; rate_hz: number; clicks: number; found: number; level_db: number; snr_db: number; ltas_error_db: number; ltas_denoised_error_db: number; modulation_error_db: number }
interface Result { banks: MadeBank[]; failures: string[]; warnings: string[] }

/** Figures of finished banks; their pictures when one is chosen. */
const results = () => {
  const rows = h('tbody', {}), notes = h('div', { class: 'stack' }), detail = h('div', { class: 'stack' });
  let plots: ReturnType<typeof bankPlots> | null = null, turn = 0;
  const look = async (name: string): Promise<void> => {
    const mine = ++turn;
    plots?.close();
    detail.replaceChildren(loading(`Reading ${name}`));
    try {
      const bank = await askJson<Bank>(`/banks/${name}`);
      if (mine !== turn) return;
      plots = bankPlots();
      detail.replaceChildren(h('h2', {}, name), bankFacts(bank), plots.element);
      plots.show(bank);
    } catch (error) {
      if (mine === turn) detail.replaceChildren(failed(error, () => void look(name)));
    }
  };
  const seen = new Map<string, HTMLTableRowElement>();
  const row = (name: string, cells: (string | number)[]): void => {
    const made = h('tr', {}, h('td', {}, button(name, () => void look(name), { class: 'link' })), ...cells.map((cell) => h('td', { class: 'n' }, cell)));
    seen.get(name)?.replaceWith(made);
    if (!seen.has(name)) rows.append(made);
    seen.set(name, made);
    if (seen.size === 1 && !detail.firstChild) void look(name);
  };
  const heads = ['Bank', 'Impacts', 'Rate, Hz', 'Level, dB', 'Over the noise, dB', 'Spectrum off target, dB', 'Off denoised, dB', 'Modulation off by, dB'];
  const table = h('div', { class: 'panel wide' }, h('h2', {}, 'Finished banks'), h('table', {},
    h('thead', {}, h('tr', {}, ...heads.map((words, n) => h('th', { scope: 'col', class: n ? 'n' : '' }, words)))), rows));
  table.hidden = true;
  return {
    element: h('div', { class: 'stack' }, notes, table, detail),
    show: (job: Job<Result>) => {
      for (const name of job.done ?? []) if (!seen.has(name)) row(name, ['', '', '', '', '', '', '']);
      for (const bank of job.result?.banks ?? [])
        row(bank.bank, [bank.found, shown(bank.rate_hz, 0.1), shown(bank.level_db, 0.1), shown(bank.snr_db, 0.1), shown(bank.ltas_error_db, 0.1), shown(bank.ltas_denoised_error_db, 0.1), shown(bank.modulation_error_db, 0.1)]);
      table.hidden = seen.size === 0;
      if (job.result) notes.replaceChildren(...[...job.result.failures, ...job.result.warnings].map((line) => h('p', { class: 'note' }, line)));
    },
    close: () => { ++turn; plots?.close(); },
  };
};

export const analysePage: Page = {
  id: 'analyse', title: 'Analyse', about: 'From labelled parts to banks',
  open: async (place, tools, state) => {
    const first = state.recordings[0];
    if (!first) {
      place.replaceChildren(noRecordings());
      return { close: () => undefined };
    }
    const closing = new AbortController(), running = h('div', { class: 'stack' }), list = h('div', { class: 'form' }), found = results();
    const note = h('p', { class: 'note', role: 'status' });
    let recording: Recording = first, parts: Part[] = [], wanted = new Set<Part>(), clicks = 10, method = 'click-nmf';
    const start = button('Analyse', () => void run(), { class: 'main', 'aria-keyshortcuts': 'Enter' });
    const wrong = (error: unknown): void => { if (!closing.signal.aborted) note.textContent = error instanceof Error ? error.message : String(error); };
    const follow = async (id: string, label: string): Promise<void> => {
      const row = progressRow(label, () => void stopJob(id).catch(wrong));
      running.prepend(row.element);
      await followJob<Result>(id, (job) => { row.show(job); found.show(job); }, closing.signal).catch(wrong);
    };
    const run = async (): Promise<void> => {
      if (start.disabled) return;
      note.textContent = '';
      try {
        const some = wanted.size < parts.length ? { parts: [...wanted].map(({ from_s, to_s }) => ({ from_s, to_s })) } : {};
        const { id } = await startJob({ kind: 'analyze', recording: recording.id, ...some, clicks, method });
        void follow(id, recording.name);
      } catch (error) { wrong(error); }
    };
    const allow = (): void => { start.disabled = !state.writable || (parts.length > 0 && wanted.size === 0); };
    const choose = async (id: string): Promise<void> => {
      recording = state.recordings.find((each) => each.id === id) ?? first;
      parts = [];
      wanted = new Set();
      list.replaceChildren(loading('Reading its labels'));
      try {
        const track = await readTrack(id);
        if (recording.id !== id) return;
        parts = track.parts;
        wanted = new Set(parts);
        const problems = track.problems.map((problem) => h('p', { class: 'note' }, problem));
        list.replaceChildren(...problems, ...(parts.length === 0 ? [h('p', { class: 'quiet' }, 'No labels: the whole recording becomes one bank. Annotate says which part is what.')]
          : parts.map((part) => tick(`${clock(part.from_s, 1)} to ${clock(part.to_s, 1)}: ${partWords(part)}`, true, (on) => { if (on) wanted.add(part); else wanted.delete(part); allow(); }).element)));
      } catch (error) { list.replaceChildren(failed(error, () => void choose(id))); }
      allow();
    };
    tools.replaceChildren(start);
    place.replaceChildren(note, h('div', { class: 'columns two' },
      h('section', { class: 'panel form', 'aria-label': 'What is analysed' }, pick('Recording', state.recordings.map(({ id, name }) => [id, name] as const), first.id, (id) => void choose(id)).element, list),
      h('section', { class: 'panel form', 'aria-label': 'How' }, choice('Method', [['click-nmf', 'Click by click'], ['paper', 'As the paper']], 'click-nmf', (value) => { method = value; }).element,
        number('Clicks in a bank', { min: 2, max: 1000, step: 1 }, clicks, (value) => { clicks = value; }).element,
        h('p', { class: 'quiet' }, `Up to ${state.cores} recordings are analysed at once; further ones wait. What is finished stays when the rest is stopped.`))),
    running, found.element);
    await choose(first.id);
    const { jobs } = await askJson<{ jobs: Job[] }>('/jobs');
    jobs.filter((job) => job.kind === 'analyze' && !ended(job)).reverse().forEach((job) => void follow(job.id, `Begun before (${job.id})`));
    return { shortcuts: [{ key: 'Enter', does: 'Analyse', run: () => void run() }], close: () => { closing.abort(); found.close(); } };
  },
};
