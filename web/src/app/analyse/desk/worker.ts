/** The worker of a desk. */

import { type DeskPort, serveDesk } from "./server.ts";

serveDesk(globalThis as unknown as DeskPort);
