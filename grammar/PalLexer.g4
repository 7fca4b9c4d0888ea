// The words of PAL. Keywords are read in any case; names keep theirs. A hyphen inside a word belongs to it.
lexer grammar PalLexer;

// Told apart before the parser runs (pal/syntax/token_list.cpp), so that a forgotten END is noticed where it is
// missing. END is told apart by the word that follows it. HEADER is the first of two kind words that a colon
// follows (`Skill Module: SM1`).
tokens { END_CASE, END_CONCURRENT, END_WTM, HEADER }

// Reserved: these begin, divide or end a statement, and name nothing.
WTM           : W T M ;
TXM           : T X M ;
SPC           : S P C ;
RPC           : R P C ;
CASE          : C A S E ;
REPEAT        : R E P E A T ;
UNTIL         : U N T I L ;
CONCURRENT    : C O N C U R R E N T ;
BEGIN         : B E G I N ;
END           : E N D ;
EXECUTE       : E X E C U T E ;
DO            : D O ;
ELSE          : E L S E ;
TRUE          : T R U E ;
FALSE         : F A L S E ;
AND           : A N D ;
OR            : O R ;
NOT           : N O T ;
NONE          : N O N E ;
FROM          : F R O M ;
TO            : T O ;
REQUEST       : R E Q U E S T ;

// These begin a unit of a file. They may name anything but an activity, so that a forgotten END cannot turn the
// next unit into statements.
USES          : U S E S ;
MESSAGE       : M E S S A G E ;
CONDITION     : C O N D I T I O N ;
DEVICE        : D E V I C E ;
SKILL         : S K I L L ;
SENSOR        : S E N S O R ;
LOGICAL       : L O G I C A L ;
MACHINE       : M A C H I N E ;
CONTINGENCY   : C O N T I N G E N C Y ;
ENVIRONMENT   : E N V I R O N M E N T ;

// These mean something in their places only; everywhere else they are names.
ACTIVITY      : A C T I V I T Y ;
AFTER         : A F T E R ;
AGE           : A G E ;
ANSWER        : A N S W E R ;
AT            : A T ;
BETWEEN       : B E T W E E N ;
BOOLEAN       : B O O L E A N ;
BUSY          : B U S Y ;
COLLECTING    : C O L L E C T I N G ;
COMPLETION    : C O M P L E T I O N ;
CONTROLLER    : C O N T R O L L E R ;
COORDINATOR   : C O O R D I N A T O R ;
COST          : C O S T ;
DATA          : D A T A ;
DEFAULT       : D E F A U L T ;
DESCRIPTION   : D E S C R I P T I O N ;
DRIVER        : D R I V E R ;
DURATION      : D U R A T I O N ;
DURING        : D U R I N G ;
EACH          : E A C H ;
ERROR         : E R R O R ;
EVENT         : E V E N T ;
EVERY         : E V E R Y ;
FIRST         : F I R S T ;
FOREVER       : F O R E V E R ;
FRAMES        : F R A M E S ;
GENERIC       : G E N E R I C ;
IN            : I N ;
INTEGER       : I N T E G E R ;
INTERVAL      : I N T E R V A L ;
JITTER        : J I T T E R ;
LATENCY       : L A T E N C Y ;
LEAST         : L E A S T ;
LOAD          : L O A D ;
LOCATION      : L O C A T I O N ;
LOSS          : L O S S ;
METHOD        : M E T H O D ;
MODEL         : M O D E L ;
MODULE        : M O D U L E ;
MOST          : M O S T ;
NEVER         : N E V E R ;
NONPREEMPTIVE : N O N P R E E M P T I V E ;
NORMAL        : N O R M A L ;
NOTHING       : N O T H I N G ;
OF            : O F ;
ON            : O N ;
PARAMETER     : P A R A M E T E R ;
PERIOD        : P E R I O D ;
PHASE         : P H A S E ;
PLACE         : P L A C E ;
POSTCONDITION : P O S T C O N D I T I O N ;
PRECONDITION  : P R E C O N D I T I O N ;
PRIORITY      : P R I O R I T Y ;
PROCESSOR     : P R O C E S S O R ;
PROCESSORS    : P R O C E S S O R S ;
PROTOCOL      : P R O T O C O L ;
RANGE         : R A N G E ;
REACTION      : R E A C T I O N ;
READ          : R E A D ;
READS         : R E A D S ;
REAL          : R E A L ;
RECEIVE       : R E C E I V E ;
REQUIREMENT   : R E Q U I R E M E N T ;
RESPONSE      : R E S P O N S E ;
RETURNS       : R E T U R N S ;
SEND          : S E N D ;
SET           : S E T ;
SIGNAL        : S I G N A L ;
SPORADIC      : S P O R A D I C ;
TEST          : T E S T ;
TEXT          : T E X T ;
TIME          : T I M E ;
WITHIN        : W I T H I N ;
WRITES        : W R I T E S ;

LEFT          : '(' ;
RIGHT         : ')' ;
COLON         : ':' ;
SEMICOLON     : ';' ;
COMMA         : ',' ;
EQUAL         : '=' ;
STAR          : '*' ;
SLASH         : '/' ;
CARET         : '^' ;
DOT           : '.' ;
PERCENT       : '%' ;
LEFT_BRACKET  : '[' ;
RIGHT_BRACKET : ']' ;

NAME          : [a-zA-Z_] [a-zA-Z0-9_]* ( '-' [a-zA-Z0-9_]+ )* ;
NUMBER        : '-'? [0-9]+ ( '.' [0-9]+ )? ( [eE] [+-]? [0-9]+ )? ;
STRING        : '"' ( ~["\\\r\n] | '\\' ~[\r\n] )* '"' ;

COMMENT       : '#' ~[\r\n]* -> skip ;
SPACE         : [ \t\r\n\f\u000B\uFEFF]+ -> skip ;

// What is no word at all still becomes a token: the parser's recovery is the one recovery there is.
OPEN_STRING   : '"' ( ~["\\\r\n] | '\\' ~[\r\n] )* '\\'? ;
STRAY         : . ;

fragment A : [aA] ;
fragment B : [bB] ;
fragment C : [cC] ;
fragment D : [dD] ;
fragment E : [eE] ;
fragment F : [fF] ;
fragment G : [gG] ;
fragment H : [hH] ;
fragment I : [iI] ;
fragment J : [jJ] ;
fragment K : [kK] ;
fragment L : [lL] ;
fragment M : [mM] ;
fragment N : [nN] ;
fragment O : [oO] ;
fragment P : [pP] ;
fragment Q : [qQ] ;
fragment R : [rR] ;
fragment S : [sS] ;
fragment T : [tT] ;
fragment U : [uU] ;
fragment V : [vV] ;
fragment W : [wW] ;
fragment X : [xX] ;
fragment Y : [yY] ;
fragment Z : [zZ] ;
