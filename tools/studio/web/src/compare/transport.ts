// Play, place and loop of a sound, with its outline to click on.
import type { SwitchingPlayer } from '../audio/switching_player';
import { Surface } from '../chart/surface';
import { h } from '../dom/element';
import { button, slider } from '../dom/fields';
import { onFrame } from '../dom/frames';
import { clock } from '../dom/number_text';

/** Least and most sample of every column. */
const outlineOf = (buffer: AudioBuffer, columns: number): [number, number][] => {
  const samples = buffer.getChannelData(0), step = samples.length / columns;
  return Array.from({ length: columns }, (_, n) => {
    let low = 0, high = 0;
    for (let i = Math.floor(n * step); i < Math.floor((n + 1) * step); ++i) {
      const v = samples[i] ?? 0;
      if (v < low) low = v;
      if (v > high) high = v;
    }
    return [low, high];
  });
};

export const transport = (player: SwitchingPlayer, buffers: () => AudioBuffer | undefined) => {
  const surface = new Surface('Outline of the sound that is heard', { left: 6, right: 6, top: 6, bottom: 6 });
  const play = button('Play', () => toggle(), { class: 'main play', 'aria-keyshortcuts': 'Space' });
  const place = slider({ label: 'Position', unit: 's', min: 0, max: Math.max(0.01, player.length_s), step: 0.01, value: 0, change: (at) => player.seek(at) });
  const toggle = (): void => {
    if (player.playing) player.stop();
    else player.play();
    show();
  };
  const show = (): void => { play.textContent = player.playing ? 'Stop' : 'Play'; };
  player.onEnd = show;
  const known = new Map<AudioBuffer, [number, number][]>();
  const draw = (): void => {
    const buffer = buffers();
    if (!buffer) return;
    const columns = Math.max(2, Math.floor(surface.inner.width));
    let outline = known.get(buffer);
    if (outline?.length !== columns) known.set(buffer, outline = outlineOf(buffer, columns));
    const most = outline.reduce((highest, [low, high]) => Math.max(highest, -low, high), 1e-6);
    surface.start({ x: { from: 0, to: buffer.duration, unit: 's' }, y: { from: -most, to: most, unit: '' } });
    outline.forEach(([low, high], n) => surface.bar(n / columns * buffer.duration, (n + 1) / columns * buffer.duration, low, high, 'second'));
    const at = player.position_s();
    surface.line([[at, -most], [at, most]], 'first', { width: 2 });
  };
  surface.canvas.addEventListener('click', (event) => { player.seek(Math.max(0, Math.min(player.length_s, surface.valueAt(event.offsetX)))); });
  let shownAt = -1;
  const stop = onFrame(() => {
    const at = player.position_s();
    if (Math.abs(at - shownAt) < 0.004) return;
    shownAt = at;
    place.set(at);
    draw();
  });
  surface.onResize = draw;
  return {
    element: h('div', { class: 'transport' }, play, h('div', { class: 'grow' }, surface.element, place.element), h('output', { class: 'quiet' }, clock(player.length_s, 1))),
    shortcuts: [{ key: ' ', does: 'Play, stop', run: toggle }],
    redraw: () => { shownAt = -1; }, close: () => { stop(); surface.close(); player.stop(); },
  };
};
