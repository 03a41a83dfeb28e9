// SPDX-License-Identifier: MIT
// A tab that can go out of sight. Playwright tells each of its pages that it is in front of the user;
// of one that speaks the DevTools protocol alone, Chromium itself says when another tab covers it.
import path from "node:path";

import WebSocket from "ws";

import { CHROMIUM, FLAGS } from "./browser.mjs";
import { Program, scratch_folder, until } from "./processes.mjs";

export class VisibleTab {
  #browser;
  #socket;
  #target;
  #session;
  #waiting = new Map();
  #number = 0;

  static async open(url) {
    const tab = new VisibleTab();
    await tab.#connect(url);
    return tab;
  }
  /** Of an expression in the page. */
  async value_of(expression) {
    const { result } = await this.#send("Runtime.evaluate", { expression, returnByValue: true }, this.#session);
    return result?.value;
  }
  /** As Playwright's. */
  get keyboard() {
    const send = (type, code) =>
      this.#send("Input.dispatchKeyEvent", { type, code, key: code.at(-1).toLowerCase() }, this.#session);
    return { down: (code) => send("keyDown", code), up: (code) => send("keyUp", code) };
  }
  /** Another tab of its window. */
  cover() {
    return this.#send("Target.createTarget", { url: "about:blank" });
  }
  show() {
    return this.#send("Target.activateTarget", { targetId: this.#target });
  }
  async close() {
    this.#socket.close();
    await this.#browser.end("SIGTERM");
  }
  async #connect(url) {
    const folder = scratch_folder();
    const args = ["--headless", "--remote-debugging-port=0", `--user-data-dir=${folder}`, ...FLAGS, url];
    this.#browser = new Program(CHROMIUM, args, path.join(folder, "chromium.log"));
    const [, address] = await this.#browser.said(/listening on (ws:\S+)/);
    this.#socket = new WebSocket(address);
    this.#socket.on("message", (text) => {
      const { id, result, error } = JSON.parse(text);
      this.#waiting.get(id)?.(result ?? { error });
    });
    await new Promise((resolve, reject) => this.#socket.on("open", resolve).on("error", reject));
    const page = await until("the tab is there", async () => {
      const { targetInfos } = await this.#send("Target.getTargets");
      return targetInfos.find((target) => target.type === "page");
    });
    this.#target = page.targetId;
    const attached = await this.#send("Target.attachToTarget", { targetId: this.#target, flatten: true });
    this.#session = attached.sessionId;
  }
  #send(method, params = {}, sessionId = undefined) {
    const id = ++this.#number;
    return new Promise((resolve) => {
      this.#waiting.set(id, resolve);
      this.#socket.send(JSON.stringify({ id, method, params, sessionId }));
    });
  }
}
