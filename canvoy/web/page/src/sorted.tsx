// Tables sorted by a click on the head of a column; the sorted column is in the address.
import { refine, useAddress } from "./address";

type Columns<Row> = Record<string, (row: Row) => string | number>;

/** `node`, or `-node` in reverse order; unsorted if the address has no such column. */
export function useSorted<Row>(rows: Row[], columns: Columns<Row>): Row[] {
  const asked = useAddress()("sort");
  const column = columns[asked.replace(/^-/, "")];
  if (!column) return rows;
  const sign = asked.startsWith("-") ? -1 : 1;
  return [...rows].sort((a, b) => {
    const [one, other] = [column(a), column(b)];
    return sign * (typeof one === "number" && typeof other === "number" ? one - other : String(one).localeCompare(String(other), "en", { numeric: true }));
  });
}

/** `inline`: of a grid that is no table. A third click takes the order of before. */
export function SortHead(props: { by: string; title: string; class?: string; inline?: boolean }) {
  const asked = useAddress()("sort");
  const way = asked === props.by ? "ascending" : asked === `-${props.by}` ? "descending" : undefined;
  const next = way === "ascending" ? `-${props.by}` : way ? "" : props.by;
  const button = (
    <button type="button" class="sort" onClick={() => refine({ sort: next })}>
      {props.title}{way && <span aria-hidden="true">{way === "ascending" ? " ▴" : " ▾"}</span>}
    </button>
  );
  return props.inline ? <span role="columnheader" class={props.class} aria-sort={way}>{button}</span> : <th class={props.class} aria-sort={way}>{button}</th>;
}
