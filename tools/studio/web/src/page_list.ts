// The pages in the order in which a person works.
import { analysePage } from './analyse/analyse_page';
import { annotatePage } from './annotate/annotate_page';
import { comparePage } from './compare/compare_page';
import { dieselPage } from './diesel/diesel_page';
import { listenPage } from './listen/listen_page';
import { livePage } from './live/live_page';
import { refinePage } from './refine/refine_page';
import { rigPage } from './rig/rig_page';
import type { Page } from './shell/page';
import { steelPage } from './steel/steel_page';

export const pages: Page[] = [annotatePage, analysePage, comparePage, refinePage, steelPage, dieselPage, rigPage, listenPage, livePage];
