# Doxygen reads the plain comments of a header, too: those at its head, and those behind a declaration.
1s|^// |/// \\file\n/// |
2,/^#pragma once/s|^//|///|
s|\([;,{}] *\)// |\1///< |
