// Writes TypeScript types from JSON Schemas: generate_types.mjs SCHEMA OUT [SCHEMA OUT …].
// Each entry of $defs becomes an exported type; the whole schema becomes `Root`, if it says what it is.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";

const typeName = (name) =>
  name.split(/[^A-Za-z0-9]+/).filter(Boolean).map((part) => part[0].toUpperCase() + part.slice(1)).join("");
const property = (name) => (/^[A-Za-z_$][\w$]*$/.test(name) ? name : JSON.stringify(name));

const plain = { string: "string", number: "number", integer: "number", boolean: "boolean", null: "null" };

function object(schema, indent) {
  const inner = indent + "  ";
  const required = new Set(schema.required ?? []);
  const lines = Object.entries(schema.properties ?? {}).map(([name, value]) => {
    const comment = value.description ? `${inner}/** ${value.description.replaceAll("*/", "* /")} */\n` : "";
    return `${comment}${inner}${property(name)}${required.has(name) ? "" : "?"}: ${type(value, inner)};\n`;
  });
  const more = schema.additionalProperties;
  if (lines.length === 0) {
    if (more === false) return "Record<string, never>";
    return `Record<string, ${more && more !== true ? type(more, indent) : "unknown"}>`;
  }
  if (more && more !== true) lines.push(`${inner}[name: string]: unknown;\n`);
  return `{\n${lines.join("")}${indent}}`;
}

function array(schema, indent) {
  if (schema.minItems !== undefined && schema.minItems === schema.maxItems && schema.minItems <= 4)
    return `[${Array(schema.minItems).fill(type(schema.items ?? {}, indent)).join(", ")}]`;
  const item = type(schema.items ?? {}, indent);
  return /^[\w.]+$/.test(item) ? `${item}[]` : `Array<${item}>`;
}

function type(schema, indent = "") {
  if (schema === true) return "unknown";
  if (schema.$ref) return typeName(schema.$ref.split("/").at(-1).replace(/\.schema\.json$/, ""));
  if ("const" in schema) return JSON.stringify(schema.const);
  if (schema.enum) return schema.enum.map((each) => JSON.stringify(each)).join(" | ");
  if (schema.properties || schema.type === "object") return object(schema, indent);
  const choices = schema.oneOf ?? schema.anyOf;
  if (choices) return [...new Set(choices.map((each) => type(each, indent)))].join(" | ");
  if (schema.allOf) return schema.allOf.map((each) => type(each, indent)).join(" & ");
  if (schema.type === "array") return array(schema, indent);
  if (Array.isArray(schema.type)) return schema.type.map((each) => type({ ...schema, type: each }, indent)).join(" | ");
  return plain[schema.type] ?? "unknown";
}

/** An OpenRPC document's methods: the types of their params and results, by name. */
function methods(list) {
  const entries = list.map((each) => {
    const properties = Object.fromEntries(each.params.map((one) => [one.name, { ...one.schema, description: one.description }]));
    const required = each.params.filter((one) => one.required).map((one) => one.name);
    const params = type({ type: "object", properties, required, additionalProperties: false }, "  ");
    const comment = each.summary ? `  /** ${each.summary} */\n` : "";
    return `${comment}  ${JSON.stringify(each.name)}: { params: ${params}; result: ${type(each.result.schema, "  ")} };\n`;
  });
  return `\nexport interface Methods {\n${entries.join("")}}\n`;
}

export function typesOf(schema, from) {
  let out = `// Written from ${from} by scripts/generate_types.mjs.\n`;
  if (schema.type || schema.oneOf || schema.properties) out += `\nexport type Root = ${type(schema)};\n`;
  if (schema.methods) out += methods(schema.methods);
  const shared = { ...(schema.$defs ?? {}), ...(schema.components?.schemas ?? {}) };
  for (const [name, each] of Object.entries(shared)) out += `\nexport type ${typeName(name)} = ${type(each)};\n`;
  return out;
}

const argumentsGiven = process.argv.slice(2);
for (let i = 0; i + 1 < argumentsGiven.length; i += 2) {
  const [from, to] = [argumentsGiven[i], argumentsGiven[i + 1]];
  mkdirSync(dirname(to), { recursive: true });
  writeFileSync(to, typesOf(JSON.parse(readFileSync(from, "utf8")), from.replace(/^(\.\.\/)+/, "")));
}
