#include "canvoy/tools/page/api_description.hpp"

namespace canvoy::tools {

const std::string_view api_schemas = R"({
 "Error": {
  "type": "object",
  "properties": {
   "error": {"type": "string", "description": "one line"},
   "abort": {
    "type": "string",
    "description": "SDO abort code, hexadecimal",
    "pattern": "^[0-9A-F]{8}$"
   }
  },
  "required": ["error"]
 },
 "Done": {"type": "object", "properties": {"done": {"const": true}}, "required": ["done"]},
 "Description": {
  "type": "object",
  "properties": {
   "kind": {
    "enum": ["lift", "charger", "taxi", "police", "bus-line", "excavator", "charging-yard", "bus", "log"]
   },
   "source": {"type": "string", "description": "the log or the bus"},
   "command": {"type": "string", "description": "shows the same once more"},
   "buses": {"type": "array", "items": {"type": "string"}},
   "end": {"type": "number", "description": "seconds"},
   "unreadable": {"type": "integer", "description": "lines or blocks of a log"},
   "unreadable_at": {"type": "string", "description": "the first of them, and why"},
   "of_other_buses": {
    "type": "integer",
    "description": "frames of a log that are not shown: it has more buses"
   },
   "faults": {
    "type": "array",
    "items": {
     "type": "object",
     "properties": {"fault": {"type": "string"}, "text": {"type": "string"}},
     "required": ["fault", "text"]
    }
   },
   "can": {
    "type": "object",
    "properties": {
     "play": {"type": "boolean"},
     "replay": {"type": "boolean"},
     "visit": {"type": "boolean"},
     "read": {"type": "boolean"},
     "nmt": {"type": "boolean"},
     "write": {"type": "string", "description": "as --allow-write has it; empty: nothing"},
     "record": {"type": "boolean", "description": "whether a folder was given for logs"}
    }
   }
  },
  "required": ["kind", "can", "buses"]
 },
 "State": {
  "type": "object",
  "properties": {
   "time": {"type": "number"},
   "play": {"type": "object"},
   "plan": {"type": "object"},
   "snapshot": {"type": "object"},
   "summary": {"type": "object"},
   "counts": {"type": "object", "description": "frames and bits of each bus, node and service"},
   "counted": {"type": "number", "description": "the time of the counts"},
   "record": {
    "type": "object",
    "description": "the log that was begun last",
    "properties": {
     "on": {"type": "boolean"},
     "file": {"type": "string"},
     "frames": {"type": "integer"},
     "trouble": {"type": "string"}
    },
    "required": ["on", "file", "frames", "trouble"]
   }
  },
  "required": ["time", "snapshot", "counts", "counted"]
 },
 "Node": {
  "type": "object",
  "properties": {
   "bus": {"type": "string"},
   "node": {"type": "integer"},
   "device": {"type": "string"},
   "state": {"type": "string"},
   "can_state": {"type": "string"},
   "error_register": {"type": "string", "pattern": "^[0-9A-F]{2}$"}
  },
  "required": ["bus", "node", "device", "state"]
 },
 "Value": {
  "type": "object",
  "properties": {
   "node": {"type": "integer"},
   "index": {"type": "string"},
   "sub": {"type": "string"},
   "name": {"type": "string"},
   "raw": {"type": "string"},
   "value": {
    "type": ["number", "string", "boolean", "object", "array", "null"],
    "description": "with fields, an object of their names"
   },
   "unit": {"type": "string"},
   "text": {"type": "string"}
  },
  "required": ["node", "index", "sub", "raw", "value", "text"]
 },
 "Heard": {
  "type": "object",
  "properties": {
   "time": {"type": "number"},
   "bus": {"type": "string"},
   "node": {"type": "integer"},
   "text": {"type": "string", "description": "the value in words, with its unit"},
   "values": {"type": "array", "items": {"type": "object"}}
  },
  "required": ["time", "bus", "node", "text", "values"]
 },
 "Events": {
  "type": "object",
  "properties": {
   "next": {"type": "integer"},
   "events": {
    "type": "array",
    "items": {
     "type": "object",
     "properties": {
      "time": {"type": "number"},
      "event": {"type": "string"},
      "words": {"type": "string", "description": "as the terminal says it"}
     },
     "required": ["time", "event", "words"]
    }
   }
  },
  "required": ["next", "events"]
 },
 "Objects": {
  "type": "object",
  "properties": {
   "profile": {"type": "string"},
   "objects": {
    "type": "array",
    "maxItems": 300,
    "items": {
     "type": "object",
     "properties": {
      "object": {"type": "string"},
      "name": {"type": "string"},
      "profile": {"type": "string", "description": "the one that describes it"},
      "clause": {"type": "string"},
      "entries": {"type": "array", "items": {"type": "object"}}
     },
     "required": ["object", "name", "entries"]
    }
   }
  },
  "required": ["profile", "objects"]
 },
 "Trend": {
  "type": "object",
  "properties": {
   "times": {"type": "array", "items": {"type": "number"}, "description": "seconds"},
   "values": {
    "type": "object",
    "additionalProperties": {"type": "array", "items": {"type": ["number", "null"]}}
   }
  },
  "required": ["times", "values"]
 },
 "History": {
  "type": "object",
  "properties": {
   "times": {"type": "array", "items": {"type": "number"}, "description": "seconds"},
   "values": {"type": "array", "items": {"type": ["number", "string"]}, "description": "each holds until the next time"}
  },
  "required": ["times", "values"]
 },
 "Written": {
  "type": "object",
  "properties": {"written": {"const": true}},
  "required": ["written"]
 },
 "Sent": {"type": "object", "properties": {"sent": {"const": true}}, "required": ["sent"]},
 "Networks": {
  "type": "array",
  "items": {"type": "object", "properties": {"bus": {"type": "string"}}, "required": ["bus"]}
 },
 "Nodes": {"type": "array", "items": {"$ref": "#/components/schemas/Node"}},
 "Values": {"type": "object", "additionalProperties": {"$ref": "#/components/schemas/Heard"}}
})";

}  // namespace canvoy::tools
