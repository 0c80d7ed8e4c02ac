// Work that is done once a picture, while it is wanted.

export const onFrame = (draw: (now: number) => void): (() => void) => {
  let going = true;
  const step = (now: number): void => {
    if (!going) return;
    draw(now);
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
  return () => { going = false; };
};
