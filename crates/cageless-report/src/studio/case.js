// The text of a case file: values replaced in place, comments kept; links, commands, Python.

const SECTION = /^\s*\[\[?\s*([A-Za-z_]+)\s*\]\]?\s*(#.*)?$/;

function isSection(line, name) {
  const found = SECTION.exec(line);
  return found && (!name || found[1] === name);
}

// `text` with `value`, written as TOML, for `section.key` of the first such section, or `section.2.key`
// of the second; the section is added if there is none, the key if it has none.
function withValue(text, dotted, value) {
  const parts = dotted.split("."), section = parts[0], key = parts.at(-1);
  const lines = text.split("\n");
  let start = -1;
  for (let n = parts.length > 2 ? Number(parts[1]) : 1; n > 0; n--) start = lines.findIndex((line, k) => k > start && isSection(line, section));
  if (start < 0) return text.replace(/\n*$/, "\n\n") + "[" + section + "]\n" + key + " = " + value + "\n";
  let end = lines.findIndex((line, k) => k > start && isSection(line));
  if (end < 0) end = lines.length;
  const pattern = new RegExp("^(\\s*" + key + "\\s*=\\s*)([^#]*?)(\\s*#.*)?$");
  for (let k = start + 1; k < end; k++) {
    const found = pattern.exec(lines[k]);
    if (found) {
      lines[k] = found[1] + value + (found[3] || "");
      return lines.join("\n");
    }
  }
  let last = end;
  while (last > start + 1 && !lines[last - 1].trim()) last--;
  lines.splice(last, 0, key + " = " + value);
  return lines.join("\n");
}

// `text` without its sections of this name, or without these keys of them.
function without(text, section, keys) {
  const pattern = new RegExp(keys ? "^\\s*(" + keys.join("|") + ")\\s*=" : "");
  let inside = false;
  return text.split("\n").filter((line) => {
    if (isSection(line)) inside = isSection(line, section);
    return !(inside && pattern.test(line));
  }).join("\n");
}

function written(value) {
  if (typeof value === "string") return JSON.stringify(value);
  if (Array.isArray(value)) return "[" + value.map((v) => written(v)).join(", ") + "]";
  return String(value);
}

function base64url(bytes) {
  let text = "";
  bytes.forEach((b) => { text += String.fromCharCode(b); });
  return btoa(text).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

async function packed(text) {
  return base64url(await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw")));
}

async function unpackedText(code) {
  const bytes = Uint8Array.from(atob(code.replace(/-/g, "+").replace(/_/g, "/")), (c) => c.charCodeAt(0));
  return new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw")));
}

function asCommand(toml) {
  return "cageless design /dev/stdin <<'TOML'\n" + toml.replace(/\n*$/, "\n") + "TOML\n";
}

function asPython(toml) {
  return "import cageless\n\ncase = cageless.Case.from_toml(r'''\n" + toml.replace(/\n*$/, "\n")
    + "''')\nprint(case.design())\n";
}
