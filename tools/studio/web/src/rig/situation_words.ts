// Situations in the words of the page.

export const situations = ['normal', 'underfeed', 'overfeed', 'closed_rattling', 'open_rattling'] as const;

export const situationWords = (situation: string): string => {
  const words = situation.replace('_', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
};
