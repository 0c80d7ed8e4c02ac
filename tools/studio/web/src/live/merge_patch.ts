// JSON merge patch (RFC 7396), as the daemon's events use it.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
type Dictionary = { [key: string]: Json };

const isObject = (value: Json | undefined): value is Dictionary => typeof value === 'object' && value !== null && !Array.isArray(value);

export const merged = (target: Json | undefined, patch: Json): Json => {
  if (!isObject(patch)) return patch;
  const made: Dictionary = isObject(target) ? { ...target } : {};
  for (const [key, value] of Object.entries(patch))
    if (value === null) delete made[key];
    else made[key] = merged(made[key], value);
  return made;
};
