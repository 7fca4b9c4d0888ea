// The sentences of PAL. docs/reference/language.md explains them; tests/golden has one of each.
//
// Every rule with an END of its own is named in pal/syntax/first_mistake.cpp.
parser grammar PalParser;

options { tokenVocab = PalLexer; }

file : unit* EOF ;

unit
  : uses
  | messageUnit
  | conditionUnit
  | deviceUnit
  | moduleUnit
  | skillUnit
  | environmentUnit
  ;

uses : USES STRING ;

// MESSAGE wrench : fx, fy, fz : REAL N; tx, ty, tz : REAL N*m
messageUnit : MESSAGE name COLON payload ;

payload
  : SIGNAL
  | type
  | fieldGroup ( SEMICOLON fieldGroup )* SEMICOLON?
  ;

fieldGroup : name ( COMMA name )* COLON type ;

// REAL mm; REAL[255] mm. What may have a size, and what a unit, is checked where the tree is built.
type : ( REAL | INTEGER | BOOLEAN | TEXT ) size? physicalUnit? ;

// A location is a text: the name of one that is taught.
parameterType : type | LOCATION ;

size : LEFT_BRACKET NUMBER RIGHT_BRACKET ;

physicalUnit : unitFactor ( ( STAR | SLASH ) unitFactor )* | PERCENT ;

// `in` is the inch here.
unitFactor : ( NAME | IN ) ( CARET NUMBER )? ;

conditionUnit : CONDITION name ( FROM name ( COMMA name )* )? STRING? ;

deviceUnit : DEVICE name STRING? ;

// ---- modules

// Without BEGIN … END the module stands for the device of its name.
moduleUnit : header COLON name heading* ( BEGIN statements END )? ;

header : HEADER ( DRIVER | SENSOR | CONTROLLER | MODULE ) ;

kind
  : SENSOR DRIVER
  | LOGICAL SENSOR
  | MACHINE CONTROLLER
  | SKILL MODULE
  | CONTINGENCY MODULE
  ;

// Of a logical sensor also the rest of its template (thesis, section 2.3.5).
heading
  : DESCRIPTION STRING                                                                # moduleDescription
  | ACTIVITY activityName access* ( TIME interval )?                                  # activity
  | SENSOR DRIVER names                                                               # requiredDrivers
  | METHOD strings                                                                    # sensorMethods
  | RETURNS names                                                                     # returned
  ;

access : ( READS | WRITES ) name ( COMMA name )* ;

// ---- statements

statements : statement* ;

statement
  : wait
  | send
  | set
  | read
  | choose
  | repeat
  | concurrent
  | execute
  | nothing
  | perform
  ;

wait
  : WTM LEFT COORDINATOR RIGHT                                                        # waitForStart
  | WTM source                                                                        # waitForOne
  | WTM source WITHIN duration statements ( ELSE statements )? END_WTM WTM            # waitWithin
  | WTM FIRST ( WITHIN duration )? waitArm+ ( ELSE statements )? END_WTM WTM          # waitForFirst
  ;

source : LEFT message FROM party RIGHT ;

waitArm : source COLON statements ;

send
  : TXM LEFT COMPLETION PROTOCOL NUMBER RIGHT                                         # complete
  | TXM LEFT message TO party RIGHT                                                   # sendTo
  | TXM LEFT message FROM party RIGHT                                                 # ask
  ;

set : SPC LEFT name ( EQUAL truth )? RIGHT ;

read : RPC LEFT name RIGHT ;

choose : CASE arm+ END_CASE CASE ;

arm : LEFT guard RIGHT COLON statements ;

repeat : REPEAT statements UNTIL LEFT ending RIGHT ;

ending : FOREVER | guard ;

concurrent : CONCURRENT block+ END_CONCURRENT CONCURRENT ;

block : BEGIN statements END ;

execute : EXECUTE kind? name ;

nothing : DO NOTHING ;

perform : activityName ;

// ---- guards: NOT before AND before OR

guard : conjunction ( OR conjunction )* ;

conjunction : factor ( AND factor )* ;

factor : NOT* ( LEFT guard RIGHT | name ( EQUAL truth )? ) ;

truth : TRUE | FALSE ;

// ---- the parts that statements name

message : REQUEST name | name REQUEST? ;

party : kind? name ;

// ---- the skill template (thesis, section 2.3.2)

skillUnit : SKILL name slot* END SKILL ;

slot
  : DESCRIPTION STRING                                                                # descriptionSlot
  | PRECONDITION strings                                                              # preconditionSlot
  | POSTCONDITION strings                                                             # postconditionSlot
  | SENSOR DRIVER names                                                               # sensorDriverSlot
  | MACHINE CONTROLLER names                                                          # machineControllerSlot
  | LOGICAL SENSOR names                                                              # logicalSensorSlot
  | MODEL DATA strings                                                                # modelDataSlot
  | SKILL METHOD names                                                                # skillMethodSlot
  | CONTINGENCY NUMBER STRING ( METHOD name )?                                        # contingencySlot
  | PARAMETER name COLON parameterType ( DEFAULT literal )? ( RANGE literal TO literal )? STRING?  # parameterSlot
  | COMPLETION NUMBER ( NORMAL | CONTINGENCY NUMBER | ERROR ) STRING?                 # completionSlot
  | REQUIREMENT name COLON measure phase?                                             # requirementSlot
  ;

names : NONE | name ( COMMA name )* ;

strings : NONE | STRING+ ;

literal : NUMBER physicalUnit? | truth | STRING ;

measure
  : RESPONSE FROM message OF party TO step AT MOST duration                           # response
  | AGE OF known AT step AT MOST duration                                             # age
  | REACTION OF known AT step AT MOST duration                                        # reaction
  | INTERVAL OF step AT MOST duration                                                 # greatestInterval
  | INTERVAL OF step AT LEAST duration                                                # leastInterval
  | INTERVAL OF step BETWEEN duration AND duration                                    # boundedInterval
  | LOSS OF party ( NONE | AT MOST NUMBER PERCENT? IN NUMBER )                        # loss
  | DURATION TO COMPLETION NUMBER AT MOST duration                                    # completionTime
  | LOAD OF ( EACH PROCESSOR | name ) AT MOST NUMBER PERCENT                          # load
  | BUSY PERIOD OF ( EACH PROCESSOR | name ) AT MOST duration                         # busyPeriod
  ;

// The part of a run that a requirement is about: behind a statement, or in the loop around one.
phase
  : AFTER step                                                                        # afterPhase
  | DURING REPEAT OF step                                                             # duringPhase
  ;

// A condition, or what a device measures.
known : message FROM party | name ;

// Every statement of this form, of one module if one is named.
step : pattern ( IN party )? ;

pattern
  : WTM source                                                                        # waitPattern
  | TXM LEFT message TO party RIGHT                                                   # sendPattern
  | TXM LEFT message FROM party RIGHT                                                 # askPattern
  | set                                                                               # setPattern
  | read                                                                              # readPattern
  | activityName                                                                      # activityPattern
  ;

// ---- the environment (thesis, section 2.3.3)

environmentUnit : ENVIRONMENT name item* END ENVIRONMENT ;

item
  : DESCRIPTION STRING                                                                # environmentDescription
  | SENSOR DRIVER names                                                               # availableDrivers
  | LOGICAL SENSOR names                                                              # availableSensors
  | MACHINE CONTROLLER names                                                          # availableMachines
  | GENERIC SKILL names                                                               # availableSkills
  | PROCESSOR name NONPREEMPTIVE?                                                     # processor
  | DEVICE name EVENT message eventClause+                                            # eventDevice
  | DEVICE name ON REQUEST interval ( OR NEVER )?                                     # requestDevice
  | DEVICE name FRAMES frameClause+                                                   # frameDevice
  | PLACE thread ON name PRIORITY NUMBER                                              # placement
  | TIME activityName ( OF name )? COLON interval                                     # activityTime
  | COST ( SEND | RECEIVE | SET | READ | TEST ) interval                              # cost
  | LATENCY ( WITHIN PROCESSOR | BETWEEN PROCESSORS ) interval                        # latency
  ;

// SM1; its second block SM1.2; the first block of CM1 when that block executes it, SM1.2/CM1.1.
thread : threadPart ( SLASH threadPart )* ;

threadPart : name ( DOT NUMBER )? ;

eventClause
  : EVERY duration
  | SPORADIC duration
  | JITTER duration
  | PHASE duration
  | ANSWER message WITHIN duration
  ;

frameClause : EVERY duration | COLLECTING duration | PHASE duration ;

// 28 ms; 0.1 TO 0.2 ms, where the first figure has the unit of the second; 100 us TO 0.2 ms.
duration : NUMBER NAME ;

interval : NUMBER NAME? ( TO NUMBER NAME )? ;

// ---- names

activityName
  : NAME
  | contextual
  ;

name
  : NAME
  | contextual
  | opener
  ;

contextual
  : ACTIVITY | AFTER | AGE | ANSWER | AT | BETWEEN | BOOLEAN | BUSY | COLLECTING | COMPLETION | CONTROLLER
  | COORDINATOR | COST | DATA | DEFAULT | DESCRIPTION | DRIVER | DURATION | DURING | EACH | ERROR | EVENT | EVERY
  | FIRST | FOREVER | FRAMES | GENERIC | IN | INTEGER | INTERVAL | JITTER | LATENCY | LEAST | LOAD | LOCATION | LOSS | METHOD
  | MODEL | MODULE | MOST | NEVER | NONPREEMPTIVE | NORMAL | NOTHING | OF | ON | PARAMETER | PERIOD | PHASE | PLACE
  | POSTCONDITION | PRECONDITION | PRIORITY | PROCESSOR | PROCESSORS | PROTOCOL | RANGE | REACTION | READ
  | READS | REAL | RECEIVE | REQUIREMENT | RESPONSE | RETURNS | SEND | SET | SIGNAL | SPORADIC | TEST | TEXT | TIME | WITHIN
  | WRITES
  ;

// The words that begin a unit of a file.
opener
  : USES | MESSAGE | CONDITION | DEVICE | SKILL | SENSOR | LOGICAL | MACHINE | CONTINGENCY
  | ENVIRONMENT
  ;
