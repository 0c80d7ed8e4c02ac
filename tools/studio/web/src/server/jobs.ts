// Long work on the server: begun, followed, stopped.
import { askJson, askLines } from './request';

export interface Job<T = unknown> {
  id: string; kind: string; state: 'waiting' | 'running' | 'done' | 'failed' | 'stopped';
  progress: number; left_s: number | null; done?: string[]; result: T | null; error: string | null;
}

export const startJob = (body: Record<string, unknown>): Promise<{ id: string }> => askJson('/jobs', { method: 'POST', body });
export const stopJob = (id: string): Promise<Job> => askJson(`/jobs/${id}`, { method: 'DELETE' });
export const ended = (job: Job): boolean => job.state !== 'waiting' && job.state !== 'running';

/** Until the job has ended; its last state. */
export const followJob = async <T>(id: string, show: (job: Job<T>) => void, signal: AbortSignal): Promise<Job<T>> => {
  for await (const job of askLines<Job<T>>(`/jobs/${id}/events`, signal)) show(job);
  const last = await askJson<Job<T>>(`/jobs/${id}`, { signal });
  show(last);
  return last;
};
