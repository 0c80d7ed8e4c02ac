// The label track beside a recording: read, and written by the version that was seen.
import { askJson, ServerError } from '../server/request';
import { inOrder, type Part } from './part';

export interface LabelTrack { version: string; parts: Part[]; problems: string[] }

export const readTrack = (recording: string): Promise<LabelTrack> => askJson(`/recordings/${recording}/labels`);

export type Written = { kind: 'saved'; track: LabelTrack } | { kind: 'changed'; version: string };

/** Rejects with the server's line when a part cannot be written. */
export const writeTrack = async (recording: string, version: string, parts: readonly Part[]): Promise<Written> => {
  const body = { version, parts: inOrder(parts).map(({ from_s, to_s, situation, rods, rock, rpm, feed, percussion }) => ({ from_s, to_s, situation, rods, rock, rpm, feed, percussion })) };
  try {
    return { kind: 'saved', track: await askJson<LabelTrack>(`/recordings/${recording}/labels`, { method: 'PUT', body }) };
  } catch (error) {
    if (error instanceof ServerError && error.status === 409) return { kind: 'changed', version: String(error.answer.version) };
    throw error;
  }
};
