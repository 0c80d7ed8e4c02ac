// What a daemon says of itself (tools/rigsoundd/PROTOCOL.md), as far as the page shows it.

export interface LiveSignal { value: number; unit: string; validity: string; word?: string; refused?: number; clamped?: number; age_s?: number }
export interface Level { peak_db: number; rms_db: number }
export interface LiveBoom {
  situation: string; hammering: boolean; feed_deviation: number; rods: number; rock: number | string;
  banks: { name: string; share: number }[];
  impacts_wanted_hz: number; impacts_made_hz: number;
  levels?: Record<string, Level>;
  [control: string]: unknown;
}
export interface Status {
  rig?: string; version?: string; uptime_s?: number; muted?: boolean; paused?: boolean; no_buses?: boolean;
  audio?: { playing: boolean; card: string; load?: number; xruns?: number; deadline_misses?: number; scheduling?: string };
  meters?: Level & { limiter_db: number; lost_clicks: number; diesel?: Level };
  signals?: Record<string, LiveSignal>;
  buses?: Record<string, { up: boolean; problem: string }>;
  booms?: Record<string, LiveBoom>;
}

export type LiveEvent = { event: 'change'; uptime_s: number; missed: number; change: Status } | { event: 'gone'; error: string } | { ok: boolean; error?: string };
