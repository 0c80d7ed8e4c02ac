// A line with more points than columns of pixels, reduced to what can be seen of it.

type Point = readonly [number, number];

/** Lowest and highest point of every column of one pixel, in the order of the line. */
export const reduced = (line: readonly Point[]): Point[] => {
  const kept: Point[] = [];
  for (let from = 0, to = 0; from < line.length; from = to) {
    const column = Math.floor((line[from] as Point)[0]);
    let low = from, high = from;
    for (to = from + 1; to < line.length && Math.floor((line[to] as Point)[0]) === column; ++to) {
      const y = (line[to] as Point)[1];
      if (y < (line[low] as Point)[1]) low = to;
      if (y > (line[high] as Point)[1]) high = to;
    }
    kept.push(line[Math.min(low, high)] as Point);
    if (low !== high) kept.push(line[Math.max(low, high)] as Point);
  }
  return kept;
};
