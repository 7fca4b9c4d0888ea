// What esbuild bundles, and TypeScript does not know: style sheets, and the addresses of threads of their own.
declare module "*.css";
declare module "*?address" {
  const address: string;
  export default address;
}
