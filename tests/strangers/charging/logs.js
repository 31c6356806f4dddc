'use strict';

const assert = require('assert');
const {spawnSync} = require('child_process');
const fs = require('fs');

// Two clocks of the kernel's are read for a time stamp in microseconds.
const ROUNDING = 0.000002;

// The lines between two frames that occur once.
function between(file, begin, end) {
  const lines = fs.readFileSync(file, 'utf8').split('\n').filter((line) => line !== '').map((line) => {
    const [, time, interface_, frame] = /^\((\d{10}\.\d{6})\) (\S+) (\S+)$/.exec(line) ?? assert.fail(`${file}: ${line}`);
    return {time: Number(time), interface: interface_, frame};
  });
  const at = (frame) => lines.findIndex((line) => line.frame === frame);
  assert.ok(at(begin) >= 0 && at(end) > at(begin), `${file} is not complete`);
  return lines.slice(at(begin), at(end) + 1);
}

// Asserts that two candump logs have the same frames in the same order, at the same time. Returns how many.
function assertSameLog(expected, actual, begin, end) {
  const theirs = between(expected, begin, end);
  const ours = between(actual, begin, end);
  const texts = (lines) => lines.map((line) => `${line.interface} ${line.frame}`);
  assert.deepStrictEqual(texts(ours), texts(theirs));
  theirs.forEach((line, i) => {
    assert.ok(Math.abs(line.time - ours[i].time) < ROUNDING, `frame ${i}: at ${line.time} and ${ours[i].time}`);
  });
  return theirs.length;
}

const SEGMENT_REQUEST = /#[67]0/;

// What a client may still say when its server has given the transfer up (after 1 s): a stranger on a busy machine is
// slower than that, and the mark is right.
function isBehindTimeOut(frame, before) {
  if (frame.service !== 'SDO request' || !SEGMENT_REQUEST.test(frame.frame)) return false;
  const answers = before.filter(({service, node}) => service === 'SDO response' && node === frame.node);
  return /05040000h/.test(answers.at(-1)?.text);
}

// Asserts that each frame of a log is of one of the services, and none is marked but candump's first one, which says
// that it listens. Returns how many.
function assertDecodes(command, log, profile, services) {
  const options = ['decode', log, '--json', '--profile', profile];
  const {status, stdout, stderr} = spawnSync(command, options, {encoding: 'utf8', maxBuffer: 1 << 26});
  assert.strictEqual(status, 0, stderr);
  const frames = stdout.trim().split('\n').map((line) => JSON.parse(line)).filter(({frame}) => frame !== '7FF#');
  frames.forEach((frame, i) => {
    const isInPlace = !frame.marks || isBehindTimeOut(frame, frames.slice(0, i));
    assert.ok(services.includes(frame.service) && isInPlace, JSON.stringify(frame));
  });
  return frames.length;
}

module.exports = {assertSameLog, assertDecodes};
