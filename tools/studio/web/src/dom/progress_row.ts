// Work that takes a while: how far it is, how long it will take, and a way to stop it.
import { h } from './element';
import { button } from './fields';
import { clock } from './number_text';
import type { Job } from '../server/jobs';

const words = (job: Job): string => {
  if (job.state === 'waiting') return 'waits for a free core';
  if (job.state === 'failed') return job.error ?? 'failed';
  if (job.state !== 'running') return job.state;
  return job.left_s === null ? `${Math.round(100 * job.progress)} %` : `${Math.round(100 * job.progress)} %, ${clock(job.left_s)} left`;
};

export const progressRow = (label: string, stop: () => void) => {
  const bar = h('progress', { max: 1, 'aria-label': label }), text = h('span', { class: 'quiet', role: 'status' });
  const end = button('Stop', stop, { 'aria-label': `Stop ${label}` });
  const element = h('div', { class: 'progress' }, h('span', {}, label), bar, text, end);
  return {
    element,
    show: (job: Job) => {
      bar.value = job.state === 'done' ? 1 : job.progress;
      text.textContent = words(job);
      text.classList.toggle('warn', job.state === 'failed');
      end.disabled = job.state !== 'running' && job.state !== 'waiting';
    },
  };
};
