// The token comes in the fragment of the address, which no browser sends. It is kept for this tab alone, and taken
// out of the address so that a picture of the screen does not show it.
const key = "workcell-token";

export function takeToken(): string {
  const fragment = new URLSearchParams(location.hash.slice(1));
  const given = fragment.get("token");
  if (given) {
    sessionStorage.setItem(key, given);
    history.replaceState(null, "", location.pathname + location.search);
  }
  return given ?? sessionStorage.getItem(key) ?? "";
}

export function keepToken(token: string): void {
  sessionStorage.setItem(key, token);
}

export function webSocketAddress(): string {
  return `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/`;
}
