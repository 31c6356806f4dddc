// The picture of a report, with a slider: the rest of the file is text, and needs no script.
import { render } from "preact";
import { useState } from "preact/hooks";
import { live, merge, type Json } from "./live";
import { time_text } from "./parts";
import { texts } from "./texts";
import { worlds } from "./worlds";

/** Decodes base64 of JSON compressed by gzip. */
async function unpacked(text: string): Promise<Json> {
  const bytes = Uint8Array.from(atob(text.trim()), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).json();
}

function Pictures(props: { all: Json[] }) {
  const { all } = props;
  const [shown, show] = useState(all.length - 1);
  const Picture = worlds[live.hello.kind];
  const picture = all[shown];
  live.state = picture;
  return (
    <section>
      <label class="field picture-time">
        <span>{texts.report_picture} <b class="number">{time_text(picture.time, 0)}</b></span>
        <input type="range" min={0} max={all.length - 1} value={shown} aria-valuetext={time_text(picture.time, 0)} onInput={(event) => show(Number(event.currentTarget.value))} />
      </label>
      <Picture />
    </section>
  );
}

async function draw() {
  const told = await unpacked(document.getElementById("data")!.textContent!);
  live.hello = { ...told.about, can: {} };
  // Each picture is stored as the changes from the previous one (RFC 7386).
  const all: Json[] = [];
  for (const change of told.pictures) all.push(merge(all.at(-1), change));
  render(<Pictures all={all} />, document.getElementById("picture")!);
}
void draw();
