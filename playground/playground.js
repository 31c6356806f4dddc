// The live page without a server: what the page says to its WebSocket goes to a worker, which plays
// the network that the address names, as `?run=lift --lifts 3`.
"use strict";

(() => {
  const usual = "lift --lifts 2 --floors 8 --for 1h";
  const command = new URLSearchParams(location.search).get("run") ?? usual;
  const worker = new Worker("worker.js");
  const asked = new Map(); // paths of the API, by number
  let socket = null;
  let is_playing = false;

  class Socket {
    constructor(url) {
      this.wants_values = !String(url).includes("values=off");
      socket = this;
      if (is_playing) setTimeout(() => this.open());
    }
    open() {
      worker.postMessage({ connect: this.wants_values });
      this.onopen?.();
    }
    send(text) {
      worker.postMessage({ said: text });
    }
    close() {}
  }
  globalThis.canvoy_socket = (url) => new Socket(url);

  const tell = (text) => {
    const line = document.getElementById("playground-says");
    line.textContent = text;
    line.hidden = text === "";
  };
  worker.onmessage = ({ data }) => {
    if (data.message !== undefined) socket?.onmessage?.({ data: data.message });
    if (data.playing !== undefined) {
      is_playing = true;
      tell("");
      socket?.open();
    }
    if (data.refused !== undefined) {
      tell(data.refused);
      if (is_playing) document.documentElement.classList.add("stale");
    }
    if (data.got !== undefined) {
      asked.get(data.id)?.(data.got);
      asked.delete(data.id);
    }
  };
  worker.onerror = () => tell("the module cannot be loaded: a browser from 2022 on plays it, from a web server");
  worker.postMessage({ begin: `run ${command}` });

  const get = (path) =>
    new Promise((resolve) => {
      const id = asked.size + Math.random();
      asked.set(id, resolve);
      worker.postMessage({ get: { path, id } });
    });

  /** What a server would give as a file. */
  const save = async (link) => {
    const made = document.createElement("a");
    made.href = URL.createObjectURL(new Blob([await get(`/${link.getAttribute("href")}`)]));
    made.download = link.download;
    made.click();
    setTimeout(() => URL.revokeObjectURL(made.href), 10_000);
  };
  addEventListener("click", (event) => {
    const link = event.target.closest?.('a[download][href^="api/"]');
    if (!link) return;
    event.preventDefault();
    void save(link);
  });

  addEventListener("DOMContentLoaded", () => {
    const form = document.getElementById("playground");
    const field = form.elements.run;
    field.value = command;
    // All of a list is shown only where the field is empty.
    field.addEventListener("focus", () => field.select());
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      location.assign(`?run=${encodeURIComponent(field.value.trim() || usual)}`);
    });
    form.elements.example.addEventListener("change", (event) => {
      if (event.target.value) location.assign(`?run=${encodeURIComponent(event.target.value)}`);
    });
  });
})();
