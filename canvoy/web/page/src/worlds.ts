// The pictures that there are, by the kind of the network.
import type { ComponentChildren, JSX } from "preact";
import { BusLineWorld, PoliceWorld, TaxiWorld } from "./world_cars";
import { ChargerWorld } from "./world_charger";
import { ExcavatorWorld } from "./world_excavator";
import { LiftWorld } from "./world_lift";

export type Picture = (props: { children?: ComponentChildren }) => JSX.Element;

export const worlds: Record<string, Picture> = {
  lift: LiftWorld, charger: ChargerWorld, taxi: TaxiWorld, police: PoliceWorld, "bus-line": BusLineWorld, excavator: ExcavatorWorld,
};
