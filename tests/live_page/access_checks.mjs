// SPDX-License-Identifier: MIT
// What pages of others, and people without the token, get of the live page in a real browser.
//
// usage: node access_checks.mjs
import http from "node:http";

import { open_page, shows_map, start_browser, stats, view } from "./browser.mjs";
import { sleep, until } from "./processes.mjs";
import { Report, require } from "./report.mjs";
import { start_demo } from "./robots.mjs";

const FORBIDDEN = 403;
const UNAUTHORIZED = 401;
// Until the page knows what the robot does.
const STATE_MS = 500;

const report = new Report();
const demo = await start_demo(["--speed", "2", "--listen", "0.0.0.0:0"]);
const shown = new URL(demo.url);
const token = shown.searchParams.get("token");
const own_url = `http://127.0.0.1:${shown.port}/?token=${token}`;
const strangers = http.createServer((_, response) => {
  response.writeHead(200, { "Content-Type": "text/html" }).end("<!doctype html><title>a page of others</title>");
});
await new Promise((resolve) => strangers.listen(0, "127.0.0.1", resolve));
const browser = await start_browser();
const { page: own, context } = await open_page(browser, own_url);
await shows_map(own);
// In the browser of somebody who is let in: his cookie goes with it.
const foreign = await context.newPage();
// Of answers that the browser keeps from the page, too.
const statuses = [];
const network = await context.newCDPSession(foreign);
network.on("Network.responseReceivedExtraInfo", ({ statusCode }) => statuses.push(statusCode));
await foreign.goto(`http://127.0.0.1:${strangers.address().port}/`);
await network.send("Network.enable");

await report.check("foreign_socket", async () => {
  for (const query of ["", `?token=${token}`]) {
    const outcome = await foreign.evaluate((url) => {
      return new Promise((resolve) => {
        const socket = new WebSocket(url, "echomap.v1");
        socket.onopen = () => resolve("open");
        socket.onclose = () => resolve("refused");
      });
    }, `ws://127.0.0.1:${shown.port}/ws${query}`);
    require(outcome === "refused", `a page of others opens the socket, ${query || "without a token"}`);
  }
});

await report.check("foreign_post", async () => {
  const url = `http://127.0.0.1:${shown.port}/api/v1/commands`;
  statuses.length = 0;
  for (const type of ["text/plain", "application/json"]) {
    await foreign.evaluate(
      ([address, content]) =>
        fetch(address, {
          method: "POST",
          mode: content === "text/plain" ? "no-cors" : "cors",
          credentials: "include",
          headers: { "Content-Type": content },
          body: JSON.stringify({ do: "stop", seq: 1 }),
        }).catch(() => null),
      [url, type],
    );
  }
  await until("both are answered", () => statuses.length >= 2);
  require(statuses.every((status) => status === FORBIDDEN), `POST of a page of others: ${statuses}`);
  await sleep(STATE_MS);
  const { mode } = await stats(own);
  require(mode !== "stopped", "a page of others has stopped the robot");
  return `refused with ${statuses}`;
});

await report.check("token", async () => {
  require(/^[0-9a-f]{32}$/.test(token), `the printed URL has the token ${token}`);
  const stranger = await browser.newContext();
  const page = await stranger.newPage();
  for (const query of ["", `?token=${"0".repeat(token.length)}`]) {
    const response = await page.goto(`http://127.0.0.1:${shown.port}/${query}`);
    require(response.status() === UNAUTHORIZED, `the page is served with ${response.status()} to ${query || "nobody"}`);
  }
  await page.goto(own_url);
  await shows_map(page);
  // The cookie has it from now on.
  await page.goto(`http://127.0.0.1:${shown.port}/`);
  await shows_map(page);
  const first = await view(page);
  await until("the run goes on", async () => (await view(page)).time > first.time);
});

await browser.close();
strangers.close();
await demo.end();
report.print();
