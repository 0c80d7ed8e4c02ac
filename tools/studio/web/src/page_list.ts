// The pages in the order in which a person works.
import type { Page } from './shell/page';
import { rigPage } from './rig/rig_page';

export const pages: Page[] = [rigPage];
