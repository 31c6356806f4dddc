// The API's description is valid, by a validator that others wrote, and each of its paths that is
// only read answers with what it says.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { ask, load, path_of, serve } from "./browser.mjs";

const server = await serve("run", "charger", "--web", "--speed", "60");
after(() => server.end());
const description = await (await ask(server, "/openapi.json")).json();

test("the description is valid OpenAPI 3.1", async () => {
  const { Validator } = await import(pathToFileURL(path_of("@seriousme/openapi-schema-validator")));
  const validator = new Validator();
  const result = await validator.validate(structuredClone(description));
  assert.deepEqual(result.errors ?? [], []);
  assert.equal(validator.version, "3.1");
  const broken = structuredClone(description);
  delete broken.info.title;
  assert.equal((await new Validator().validate(broken)).valid, false);
});

test("what is answered is as the description says", async () => {
  const ajv_of = createRequire(path_of("@seriousme/openapi-schema-validator"));
  const Ajv = ajv_of("ajv/dist/2020.js").default;
  const ajv = new Ajv({ strict: false });
  ajv.addSchema({ $id: "api", components: description.components });
  const values = { bus: "sim0", node: "10", object: "1018:1", names: "plant.current_a,event" };
  for (const [path, methods] of Object.entries(description.paths)) {
    const content = methods.get?.responses["200"].content["application/json"];
    if (!content) continue;
    const query = (methods.get.parameters ?? []).filter((each) => each.in === "query" && each.required).map((each) => `${each.name}=${values[each.name]}`);
    const asked = path.replace(/\{(\w+)\}/g, (_, name) => values[name]) + (query.length > 0 ? `?${query.join("&")}` : "");
    const response = await ask(server, asked);
    assert.equal(response.status, 200, asked);
    const schema = JSON.parse(JSON.stringify(content.schema).replaceAll("#/components", "api#/components"));
    const valid = ajv.compile(schema);
    assert.ok(valid(await response.json()), `${asked}: ${JSON.stringify(valid.errors)}`);
  }
});
