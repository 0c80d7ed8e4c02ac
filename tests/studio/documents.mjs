// Documents of tools/studio/server/API.md as a studio of a small sound set would give them.
const signal = (name, unit, min, max, absent, per_boom, words = null) => ({ name, unit, min, max, absent, per_boom, words, meaning: name });
const control = (name, unit, min, max, neutral) => ({ name, unit, min, max, neutral, meaning: name });

export const rig = {
  rate: 48000, block: 64, channels: 2, booms: ['boom1'], seed: 11, rocks: ['hard', 'soft'],
  feed: { contact_bar: 15, underfeed_bar: 60, overfeed_bar: 120, normal_bar: 90, largest_bar: 300 },
  signals: [signal('engine_rpm', 'r/min', 0, 4000, 0, false), signal('engine_load', '', 0, 1, -1, false),
    signal('master_gain_db', 'dB', -60, 0, 0, false), signal('simulation', '', 0, 2, 0, false, ['run', 'freeze', 'reset']),
    signal('feed_pressure_bar', 'bar', 0, 300, 0, true), signal('rattling', '', 0, 2, 0, true, ['none', 'closed', 'open']),
    signal('percussion', '', 0, 1, 2, true, ['off', 'on']), signal('rod_count', '', 1, 20, 1, true), signal('rock', '', 0, 65535, 0, true)],
  controls: [control('mean_frequency_hz', 'Hz', 1, 120, 0), control('mean_amplitude_db', 'dB', -60, 24, 0), control('deviation_time', '', 0, 4, 1),
    control('deviation_amplitude', '', 0, 4, 1), control('attack_factor', '', 0.1, 10, 1), control('decay_factor', '', 0.25, 10, 1)],
};

export const state = {
  version: '0.1.0', sound_set: { name: 'sounds', version: '5f0c' }, rig: { name: 'rig.toml', booms: ['boom1'] }, recordings: [],
  logs: [{ id: 'c00f12ab9931', name: 'shift.log' }], daemon: false, writable: true, cores: 2, problems: [],
};

export const soundSet = { version: '5f0c', name: 'sounds', banks: [], uses: [], rocks: [{ name: 'hard', stiffness: 5e8 }, { name: 'soft', stiffness: 1e8 }],
  tools: [], backgrounds: [], laws: [], problems: [] };

export const timeline = {
  name: 'shift.log', seconds: 40, notes: [],
  signals: [{ name: 'engine_rpm', boom: 0, unit: 'r/min', words: null, changes: [[0, 800], [4, 1500], [36, 800]] },
    { name: 'feed_pressure_bar', boom: 0, unit: 'bar', words: null, changes: [[0, 0], [5, 30], [10, 90], [20, 160], [28, 60], [34, 0]] }],
  situations: [{ boom: 0, changes: [[0, ''], [5, 'underfeed'], [10, 'normal'], [20, 'overfeed'], [28, 'normal'], [34, '']] }],
};

export const recording = { id: '6ad1f02c93be', name: 'normal.wav', frames: 960000, rate: 48000, channels: 1, seconds: 20, hash: '9b31c0de44aa', labels: true };
export const withRecording = { ...state, recordings: [recording] };

export const part = (from_s, to_s, more = {}) => ({ from_s, to_s, text: '', situation: 'normal', rods: null, rock: null, rpm: null, feed: null, percussion: null, ...more });

const bankOf = (name) => ({ name, version: '77aa', rate_hz: 41.9, clicks: 6, refined: false, source: 'normal.wav', recording: recording.id, from_s: 1.5, to_s: 6 });
export const withBanks = { ...soundSet, banks: [bankOf('normal_01500ms'), bankOf('overfeed_09000ms')],
  uses: [{ bank: 'normal_01500ms', situation: 'normal', rods: 2, rock: 'hard', feed_bar: 110, percussion_bar: 0, gain_db: 0 },
    { bank: 'overfeed_09000ms', situation: 'overfeed', rods: 2, rock: 'hard', feed_bar: 160, percussion_bar: 0, gain_db: 0 }],
  backgrounds: [{ name: 'diesel', rpm: [900, 1500, 2200] }] };

const third = Array.from({ length: 25 }, (_, n) => 63 * 2 ** (n / 3)), modulation = Array.from({ length: 60 }, (_, n) => 2 + 2 * n);
const bump = (x, at, width) => Math.exp(-(((x - at) / width) ** 2));
const edges = Array.from({ length: 21 }, (_, n) => 20 + 0.4 * n);
export const refinement = { version: 'absent', controls: Object.fromEntries(rig.controls.map(({ name, neutral }) => [name, neutral])), dropped: [], trim_db: 0 };
export const bank = (name) => ({
  name, version: '77aa', warnings: [],
  figures: { clicks_found: 190, rate_hz: 41.9, level_db: -20.1, snr_db: 13.2, decay_s: 0.02, ltas_error_db: 0.6, ltas_denoised_error_db: 0.8, modulation_error_db: 1.1 },
  gaps: { unit: 'ms', edges, share: edges.slice(1).map((x) => 0.2 * bump(x, 23.9, 1.4)), engine: { x: edges, y: edges.map((x) => 0.19 * bump(x, 23.9, 1.5)) } },
  amplitudes: { unit: '', edges: edges.map((x) => x / 1000), share: edges.slice(1).map((x) => 0.15 * bump(x, 24, 2)), engine: { x: edges.map((x) => x / 1000), y: edges.map((x) => 0.15 * bump(x, 24, 2.1)) } },
  third_octaves: { centre_hz: third, recorded_db: third.map((x) => -30 - 12 * Math.abs(Math.log10(x / 900))), denoised_db: third.map((x) => -31 - 15 * Math.abs(Math.log10(x / 900))), synthesised_db: third.map((x) => -31 - 15.5 * Math.abs(Math.log10(x / 920))) },
  modulation: { hz: modulation, recorded_db: modulation.map((x) => -30 + 20 * bump(x, 42, 3)), denoised_db: modulation.map((x) => -32 + 24 * bump(x, 42, 3)), synthesised_db: modulation.map((x) => -32 + 23 * bump(x, 42, 3)) },
  clicks: Array.from({ length: 6 }, (_, index) => ({ index, samples: 960, dropped: false })), refinement,
});
