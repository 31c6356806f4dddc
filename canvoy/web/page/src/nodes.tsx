// The nodes on the buses, and their state.
import { useState } from "preact/hooks";
import { ask, live, place_of, useLive, type Json } from "./live";
import { Card, State, time_text } from "./parts";
import { SortHead, useSorted } from "./sorted";
import { texts } from "./texts";

const commands = ["start", "stop", "enter pre-operational", "reset node", "reset communication"];

/** The heard parts of the identity object: vendor-ID, product code, revision and serial number. */
function Identity(props: { node: Json }) {
  const { hello } = useLive();
  const { bus, node } = props.node;
  const parts = ["01", "02", "03", "04"].map((sub) => live.values.get(place_of({ bus, node, index: "1018", sub }))?.text);
  if (parts.some((part) => part !== undefined)) {
    return <span class="mono">{parts.map((part, i) => <span key={i} title={texts.identity_parts[i]}>{i > 0 && " "}{part ?? "–"}</span>)}</span>;
  }
  if (!hello.can?.read) return null;
  const read = async () => {
    for (let sub = 1; sub <= 4; ++sub) await ask("read", { bus, node, object: `1018:${sub}` });
  };
  return <button type="button" class="small" aria-label={`${texts.identity_read}: ${props.node.device}`} onClick={read}>{texts.identity_read}</button>;
}

export function Nodes() {
  const { state, hello, events } = useLive();
  const [said, say] = useState("");
  const [picked, pick] = useState<Record<string, string>>({});
  const heard = (node: Json) => state.counts?.[node.bus]?.nodes?.[node.node]?.last;
  const nodes = useSorted<Json>(state.snapshot?.nodes ?? [], {
    device: (node) => node.device, bus: (node) => node.bus, node: (node) => node.node, state: (node) => node.state,
    controller: (node) => node.can_state ?? "", errors: (node) => node.error_register ?? "", heard: (node) => -(heard(node) ?? 0),
  });
  const emergencies = new Map<string, Json>();
  for (const event of events) {
    if (event.event === "emergency") emergencies.set(`${event.bus} ${event.node}`, event);
  }
  const command = async (node: Json, what: string) => {
    if (hello.kind === "bus" && !confirm(texts.nmt_asks(what, node.device))) return;
    const answer = await ask("nmt", { bus: node.bus, node: node.node, command: what });
    say(answer.error ?? `${node.device}: ${what}`);
  };
  return (
    <Card title={texts.views.nodes} class="nodes">
      <p class="said" role="status">{said}</p>
      {nodes.length === 0 && <p class="hint">{texts.nodes_none}</p>}
      <div class="scroll">
        <table class="plain wide">
          <thead>
            <tr>
              <SortHead by="device" title={texts.device} /><SortHead by="bus" title={texts.frame_bus} /><SortHead by="node" title={texts.node} class="number" /><SortHead by="state" title={texts.state} />
              <SortHead by="controller" title={texts.controller} /><SortHead by="errors" title={texts.errors} class="number" /><th>{texts.identity}</th><SortHead by="heard" title={texts.last_heard} /><th>{texts.last_emergency}</th>
              {hello.can?.nmt && <th>{texts.nmt}</th>}
            </tr>
          </thead>
          <tbody>
            {nodes.map((node) => {
              const emergency = emergencies.get(`${node.bus} ${node.node}`);
              const last = heard(node);
              const place = `${node.bus} ${node.node}`;
              return (
                <tr key={place}>
                  <td class="strong">{node.device}</td><td data-label={texts.frame_bus}>{node.bus}</td><td class="number" data-label={texts.node}>{node.node}</td>
                  <td><State state={node.state} /></td>
                  <td data-label={texts.controller}>{node.can_state && <State state={node.can_state} />}</td>
                  <td data-label={texts.errors} class={`number mono ${node.error_register !== "00" ? "bad-text" : ""}`}>{node.error_register}h</td>
                  <td data-label={texts.identity}><Identity node={node} /></td>
                  <td class="muted" data-label={texts.last_heard}>{last === undefined ? texts.never : texts.ago(Math.max(0, state.counted - last))}</td>
                  <td data-label={texts.last_emergency}>{emergency && <span class={emergency.code === "0000" ? "muted" : "bad-text"}>{time_text(emergency.time, 1)} {emergency.text}</span>}</td>
                  {hello.can?.nmt && (
                    <td class="together">
                      <select aria-label={`${texts.nmt}: ${node.device}`} value={picked[place] ?? commands[0]} onChange={(event) => pick({ ...picked, [place]: event.currentTarget.value })}>
                        {commands.map((each) => <option key={each}>{each}</option>)}
                      </select>
                      <button type="button" class="small" aria-label={`${texts.nmt_send}: ${node.device}`} onClick={() => void command(node, picked[place] ?? commands[0])}>{texts.nmt_send}</button>
                    </td>
                  )}
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
    </Card>
  );
}
