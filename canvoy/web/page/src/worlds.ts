// The pictures, by kind of network.
import type { JSX } from "preact";
import { BusLineWorld, PoliceWorld, TaxiWorld } from "./world_cars";
import { ChargerWorld } from "./world_charger";
import { ExcavatorWorld } from "./world_excavator";
import type { PictureProps } from "./parts";
import { LiftWorld } from "./world_lift";
import { YardWorld } from "./world_yard";

export type Picture = (props: PictureProps) => JSX.Element;

export const worlds: Record<string, Picture> = {
  lift: LiftWorld, charger: ChargerWorld, "charging-yard": YardWorld, taxi: TaxiWorld, police: PoliceWorld, "bus-line": BusLineWorld, excavator: ExcavatorWorld,
};
