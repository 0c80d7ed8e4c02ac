// What the server says (tools/studio/server/API.md), in the shapes this page reads.

export interface Recording {
  id: string; name: string; frames: number; rate: number; channels: number; seconds: number; hash: string; labels: boolean;
}

export interface State {
  version: string;
  sound_set: { name: string; version: string };
  rig: { name: string; booms: string[] } | null;
  recordings: Recording[];
  logs: { id: string; name: string }[];
  daemon: boolean; writable: boolean; cores: number; problems: string[];
}

export interface Signal {
  name: string; unit: string; min: number; max: number; absent: number; words: string[] | null; per_boom: boolean; meaning: string;
}
export interface Control { name: string; unit: string; min: number; max: number; neutral: number; meaning: string }

export interface Rig {
  rate: number; block: number; channels: number; booms: string[]; seed: number;
  feed: { contact_bar: number; underfeed_bar: number; overfeed_bar: number; normal_bar: number };
  rocks: string[];
  signals: Signal[]; controls: Control[];
}

export interface SoundSet {
  version: string; name: string; problems: string[];
  banks: { name: string; version: string; rate_hz: number; clicks: number; refined: boolean; source: string;
    recording: string | null; from_s: number; to_s: number | null }[];
  uses: { bank: string; situation: string; rods: number; rock: string; feed_bar: number; percussion_bar: number; gain_db: number }[];
  rocks: { name: string; stiffness: number }[];
  tools: { name: string; kind: string; version: string }[];
  backgrounds: { name: string; rpm: number[] }[];
}

export interface Timeline {
  name: string; seconds: number;
  signals: { name: string; boom: number; unit: string; words: string[] | null; changes: [number, number | null][] }[];
  situations: { boom: number; changes: [number, string][] }[];
  notes: string[];
}
