// The first of the page's program. It asks the cell for what it has while the browser still reads the rest.
import { connect } from "./state/cell";

connect();
void import("./main");
