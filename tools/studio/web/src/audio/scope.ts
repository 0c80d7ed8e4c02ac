// The browser's own spectrum of what sounds, drawn on a logarithmic axis with its scale.
import { onFrame } from '../dom/frames';
import { Surface } from '../chart/surface';

const kLow_hz = 50, kHigh_hz = 20000, kLow_db = -100, kHigh_db = -10;

export const spectrumView = (node: AudioNode): { element: HTMLElement; analyser: AnalyserNode; close(): void } => {
  const analyser = new AnalyserNode(node.context, { fftSize: 4096, smoothingTimeConstant: 0.75 });
  node.connect(analyser);
  const bins = new Float32Array(analyser.frequencyBinCount);
  const surface = new Surface('Spectrum of what sounds, 50 Hz to 20 kHz', { left: 44, right: 10, top: 8, bottom: 24 });
  const stop = onFrame(() => {
    analyser.getFloatFrequencyData(bins);
    const { width } = surface.inner, hzPerBin = node.context.sampleRate / analyser.fftSize;
    surface.start({ x: { from: kLow_hz, to: kHigh_hz, log: true, unit: 'Hz' }, y: { from: kLow_db, to: kHigh_db, unit: 'dB' } });
    const points: [number, number][] = [];
    for (let x = 0; x < width; ++x) {
      const from = kLow_hz * (kHigh_hz / kLow_hz) ** (x / width), to = kLow_hz * (kHigh_hz / kLow_hz) ** ((x + 1) / width);
      let highest = -Infinity;
      for (let bin = Math.floor(from / hzPerBin); bin <= Math.ceil(to / hzPerBin); ++bin) highest = Math.max(highest, bins[bin] ?? -Infinity);
      points.push([from, Math.max(kLow_db, Math.min(kHigh_db, highest))]);
    }
    surface.line(points, 'first');
  });
  return { element: surface.element, analyser, close: () => { stop(); node.disconnect(analyser); } };
};
