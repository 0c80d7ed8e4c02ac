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
