/** The worker of a desk. */

import { type DeskPort, serveDesk } from "./desk-server.ts";

serveDesk(globalThis as unknown as DeskPort);
