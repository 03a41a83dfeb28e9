// SPDX-License-Identifier: MIT
// A network between browser and server that can be slow and can be cut.
import net from "node:net";

/** Forwards each connection to that address of this machine. */
export class SlowCable {
  /** How much later bytes to the server arrive, and those to the browser. */
  to_server_ms = 0;
  to_browser_ms = 0;
  #is_cut = false;
  #server;
  #sockets = new Set();

  constructor(port, address) {
    this.#server = net.createServer((browser) => {
      const server = net.connect(port, address);
      this.#join(browser, server, () => this.to_server_ms);
      this.#join(server, browser, () => this.to_browser_ms);
    });
  }
  /** At the port of 127.0.0.1 that the server has at its address: it knows itself by that port. */
  async listen(port) {
    await new Promise((resolve, reject) => {
      this.#server.on("error", reject).listen(port, "127.0.0.1", resolve);
    });
  }
  /** Nothing passes any more and nobody is told, as when a radio is out of reach. */
  cut() {
    this.#is_cut = true;
  }
  mend() {
    this.#is_cut = false;
  }
  close() {
    this.#server.close();
    this.#sockets.forEach((socket) => socket.destroy());
  }
  /** Bytes keep their order where the delay becomes less. */
  #join(from, to, delay_ms) {
    this.#sockets.add(from);
    let due_ms = 0;
    const later = (act) => {
      due_ms = Math.max(due_ms, performance.now() + delay_ms());
      setTimeout(act, due_ms - performance.now());
    };
    from.setNoDelay(true);
    from.on("data", (bytes) => {
      if (!this.#is_cut) {
        later(() => to.writable && to.write(bytes));
      }
    });
    from.on("error", () => {});
    from.on("close", () => {
      this.#sockets.delete(from);
      later(() => to.destroy());
    });
  }
}
