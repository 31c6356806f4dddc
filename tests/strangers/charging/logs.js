'use strict';

const assert = require('assert');
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

module.exports = {assertSameLog};
