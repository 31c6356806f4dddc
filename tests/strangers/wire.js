'use strict';

// A bus between node-canopen and a program of ours (pipe_node.hpp): frames and other lines through its standard input
// and output. The time of our program goes on while the test waits only, at most ten times as fast as that of the clock,
// by which node-canopen goes.
//
//     const wire = new Wire(peer, 'panel');
//     wire.connect(new Device({id: 1, eds}));
//     await wire.until('the boot-up message', () => wire.heard.includes('705#00'));
//     wire.end();

const assert = require('assert');
const {spawn} = require('child_process');
const readline = require('readline');

const FRAME = /^([0-9A-F]{3})#([0-9A-F]*)$/;
const STEP_MS = 10; // of our program's time
const PATIENCE_MS = 30000; // of our program's time, and of ours

const soon = () => new Promise((resolve) => setTimeout(resolve, 1));

// As candump -L has them.
function frameText(id, data) {
  const hex = (data || Buffer.alloc(0)).toString('hex').toUpperCase();
  return `${id.toString(16).toUpperCase().padStart(3, '0')}#${hex}`;
}

class Wire {
  constructor(command, ...commandArguments) {
    this.heard = []; // all lines in their order; '>' before the frames of node-canopen
    this.devices = [];
    this.waiting = []; // for the answer to `until`
    this.now = 0;
    this.peer = spawn(command, commandArguments, {stdio: ['pipe', 'pipe', 'inherit']});
    readline.createInterface({input: this.peer.stdout}).on('line', (line) => this.hear(line));
    this.peer.on('exit', (status, signal) => {
      for (const {reject} of this.waiting) reject(new Error(`our program has ended: ${signal ?? status}`));
    });
    this.peer.stdin.on('error', () => {}); // it has ended, which is told above
  }

  connect(device) {
    this.devices.push(device);
    device.on('message', ({id, data}) => this.send(id, data));
  }

  hear(line) {
    if (line.startsWith('now ')) return this.waiting.shift().resolve();
    this.heard.push(line);
    const [, id, hex] = FRAME.exec(line) ?? [];
    if (!id) return undefined;
    const data = Buffer.from(hex, 'hex');
    for (const device of this.devices) {
      setImmediate(() => device.receive({id: parseInt(id, 16), data, len: data.length}));
    }
    return undefined;
  }

  send(id, data) {
    const line = frameText(id, data);
    this.heard.push('>' + line);
    this.tell(line);
  }

  tell(line) {
    this.peer.stdin.write(line + '\n');
  }

  async step() {
    this.now += STEP_MS;
    const reached = new Promise((resolve, reject) => this.waiting.push({resolve, reject}));
    if (this.peer.exitCode !== null) throw new Error(`our program has ended: ${this.peer.exitCode}`);
    this.tell(`until ${this.now}`);
    await reached;
    await soon();
  }

  async runUntil(ms) {
    while (this.now < ms) await this.step();
  }

  async pass(ms) {
    await this.runUntil(this.now + ms);
  }

  // Both times must be over: devices of node-canopen live in ours.
  async until(what, isSo) {
    const end = this.now + PATIENCE_MS;
    const giveUp = Date.now() + PATIENCE_MS;
    while (!isSo()) {
      const isOver = this.now >= end && Date.now() >= giveUp;
      assert.ok(!isOver, `${what} did not come; heard ${this.heard.slice(-20).join(' | ')}`);
      await this.step();
    }
  }

  // Resolves with the line when it comes, from there on.
  async hears(line, from = 0) {
    await this.until(line, () => this.heard.includes(line, from));
  }

  // Resolves when our program has ended, with its status.
  end() {
    const ended = new Promise((resolve) => this.peer.once('exit', resolve));
    this.peer.stdin.end();
    return ended;
  }
}

// Runs `main`, and ends with status 1 where it fails.
function run(main) {
  main().then(() => process.exit(0), (error) => {
    console.error(error);
    process.exit(1);
  });
}

module.exports = {Wire, frameText, run};
