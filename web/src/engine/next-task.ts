/**
 * Resolves in the next task, so that a worker receives its messages between two pieces of work. Nested
 * timers would work too, but browsers delay them by 4 ms each.
 */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
