// As much of Markdown as the pages on findings use: headings, paragraphs, lists, code.
import type { ReactNode } from "react";

function inline(text: string): ReactNode[] {
  return text.split(/(`[^`]+`|\*\*[^*]+\*\*|\*[^*]+\*|\[[^\]]+\]\([^)]+\))/).map((part, i) => {
    if (part.startsWith("`")) return <code key={i}>{part.slice(1, -1)}</code>;
    if (part.startsWith("**")) return <b key={i}>{part.slice(2, -2)}</b>;
    if (part.startsWith("*") && part.length > 2) return <i key={i}>{part.slice(1, -1)}</i>;
    const link = /^\[([^\]]+)\]/.exec(part);
    return link ? <span key={i}>{link[1]}</span> : part;
  });
}

export function Markdown({ text }: { text: string }) {
  const out: ReactNode[] = [];
  const blocks = text.replace(/\r/g, "").split(/(```[^\n]*\n[\s\S]*?```)|\n{2,}/).filter((each) => each !== undefined && each.trim() !== "");
  blocks.forEach((block, i) => {
    if (!block) return;
    if (block.startsWith("```")) return void out.push(<pre key={i} tabIndex={0}>{block.replace(/^```[^\n]*\n/, "").replace(/\n?```$/, "")}</pre>);
    const heading = /^(#+) (.*)$/m.exec(block);
    if (heading && block.trim() === heading[0]) return void out.push(<h4 key={i}>{inline(heading[2] ?? "")}</h4>);
    if (/^\s*[-*] /.test(block))
      return void out.push(<ul key={i} className="bulleted">{block.trim().split(/\n\s*[-*] /).map((each, j) => <li key={j}>{inline(each.replace(/^\s*[-*] /, "").replace(/\n/g, " "))}</li>)}</ul>);
    out.push(<p key={i}>{inline(block.replace(/\n/g, " ").replace(/^#+ /, ""))}</p>);
  });
  return <>{out}</>;
}
