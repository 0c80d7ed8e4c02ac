// Parts that the analysis suggests: asked for as a job, then taken or put aside one by one.
import { progressRow } from '../dom/progress_row';
import { followJob, startJob, stopJob } from '../server/jobs';
import { emptyPart, type Part, type Suggestion } from './part';

const kRhythmic = 0.5;

export const partOf = ({ from_s, to_s }: Suggestion): Part => emptyPart(from_s, to_s);

/** Those whose clicks come in a rhythm; rejects with the job's own line. Empty when it was stopped. */
export const suggest = async (recording: string, place: HTMLElement, signal: AbortSignal): Promise<Suggestion[]> => {
  const { id } = await startJob({ kind: 'suggest', recording });
  const row = progressRow('Looking for parts', () => void stopJob(id));
  place.replaceChildren(row.element);
  try {
    const job = await followJob<{ parts: Suggestion[] }>(id, row.show, signal);
    if (job.state === 'failed') throw new Error(job.error ?? 'The suggestion failed.');
    return (job.result?.parts ?? []).filter(({ rhythmic }) => rhythmic >= kRhythmic);
  } finally {
    place.replaceChildren();
  }
};
