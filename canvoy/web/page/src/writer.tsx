// An entry of an object, to read and, if permitted, to write.
import { useState } from "preact/hooks";
import { ask, live, type Json } from "./live";
import { value_text } from "./parts";
import { texts } from "./texts";

export function Writer(props: { bus: string; node: number; object: string; entry: Json }) {
  const [value, set] = useState("");
  const [said, say] = useState<Json>({});
  const { can } = live.hello;
  const { bus, node, object, entry } = props;
  const list = `names-${object.replace(":", "-")}-${node}`;
  const read = async () => say(await ask("read", { bus, node, object }));
  const write = async (event: Event) => {
    event.preventDefault();
    say(await ask("write", { bus, node, object, value }));
  };
  const number = Number(value);
  const is_out = value !== "" && entry.low !== undefined && Number.isFinite(number) && (number < entry.low || number > entry.high);
  const may_write = can?.write && !["const", "ro"].includes(entry.access);
  return (
    <form class="writer" onSubmit={write}>
      {can?.read && <button type="button" onClick={read}>{texts.read}</button>}
      {may_write && (
        <>
          <input aria-label={`${texts.write_label}: ${entry.name}`} value={value} list={list} class={is_out ? "out" : ""}
            placeholder={entry.low !== undefined ? `${value_text(entry.low)} … ${value_text(entry.high)} ${entry.unit ?? ""}` : entry.type}
            onInput={(input) => set(input.currentTarget.value)} />
          {entry.names && <datalist id={list}>{entry.names.map((name: string) => <option key={name} value={name} />)}</datalist>}
          <button type="submit">{texts.write}</button>
        </>
      )}
      <span role="status" class={said.error ? "error" : "good-text"}>
        {said.error ?? (said.written ? texts.written : said.text)}
      </span>
    </form>
  );
}
