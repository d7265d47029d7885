/*
 * carom: billiards, exact and deterministic. The C interface.
 * docs/game.md is the guide. Written by `make reference` from crates/carom-c; do not edit.
 *
 * Units. SI and radians: m, m/s, rad/s, kg, N s, s. The origin is the corner of the playing area at the
 * bottom left; x is along the table's width, y along its length, z up from the slate. A ball on the
 * cloth has z = its radius. Quaternions are x, y, z, w.
 *
 * Ownership. A pointer that a function returns is an object of the caller, to be freed once by the
 * function of its type, unless the function says that it belongs to another object. A pointer that a
 * function takes is only used during the call. Texts are UTF-8 and end in a zero. A null pointer
 * is refused like other wrong input, unless the function says what it stands for. Any other pointer must
 * point to what its type says.
 *
 * Threads. carom_table, carom_shot, carom_trace, carom_player and carom_stop may be used by any number
 * of threads at once. A carom_sim and a carom_frame belong to one thread at a time; threads may share
 * a frame that none changes. An object is freed when no thread uses it any more.
 *
 * Errors. A function that can refuse its input has the arguments error and error_size: a buffer of that
 * many bytes, or null and 0. It gets one sentence, cut to fit in whole characters:
 *     [kind] place: what is wrong; what would be right
 * The kind is a stable word (carom_error_kinds_json), the place a path in the input. After a success
 * the text is empty. Failure is a null pointer, a negative number, 0 for a hash and NaN for a time;
 * the number is CAROM_REFUSED, CAROM_EVENT_CAP or CAROM_FAULT. No panic of Rust leaves the library.
 *
 * Definitions. A struct ..._def with all bytes zero has default values; carom_default_..._def() returns
 * it. Flags are int32_t: 0 is no, any other number is yes.
 *
 * Bits. The same shot gives the same bits on every machine, in every language and for any number of
 * threads, with the same version of the engine.
 */

#ifndef CAROM_H
#define CAROM_H

#include <stddef.h>
#include <stdint.h>

// In the pockets of a batch: the ball is on the table at the end.
#define CAROM_ON_TABLE -1

// In the pockets of a batch: the ball has left the table.
#define CAROM_LEFT -2

// In the pockets of a batch: the shot has no such ball, or failed.
#define CAROM_PADDING -3

// The call was refused: an argument or an input is wrong. The text of the error says what to do.
#define CAROM_REFUSED -1

// The shot reached its cap of events; the text of the error says what to do.
#define CAROM_EVENT_CAP -2

// A fault of carom. The call has no result; please report the text of the error.
#define CAROM_FAULT -3

// The frame asks for a shot.
#define CAROM_ASKS_SHOT 0

// The frame asks for a choice.
#define CAROM_ASKS_CHOICE 1

// The frame is over.
#define CAROM_OVER 2

// The cue ball in hand may be put anywhere on the table.
#define CAROM_ANYWHERE 0

// The cue ball in hand may be put behind the head string.
#define CAROM_BEHIND_HEAD_STRING 1

// The cue ball in hand may be put in the D.
#define CAROM_THE_D 2

// A ball and its pocket may be called.
#define CAROM_MAY_CALL 1

// A safety may be called.
#define CAROM_MAY_CALL_SAFETY 2

// A ball and its pocket or a safety must be called.
#define CAROM_MUST_CALL 4

// A push-out may be announced.
#define CAROM_MAY_PUSH_OUT 8

// One of the balls on must be nominated.
#define CAROM_MUST_NOMINATE 16

// Shoot, with the balls as they lie.
#define CAROM_PLAY_ON 0

// Shoot, with the cue ball in hand behind the head string.
#define CAROM_PLAY_FROM_HAND 1

// Let the other player shoot.
#define CAROM_PASS_BACK 2

// Rack again, and break.
#define CAROM_REBREAK 3

// Rack again, and let the other player break.
#define CAROM_REBREAK_BY_OTHER 4

// Spot the eight, and shoot.
#define CAROM_SPOT_EIGHT 5

// Put the balls back, and let the other player shoot again.
#define CAROM_REPLACE 6

// Spot the cue ball and the balls that touch it, and shoot.
#define CAROM_SPOT_FROZEN 7

// Spot the legal ball nearest to the head string, and shoot from behind it.
#define CAROM_SPOT_NEAREST 8

// Shoot, with the cue ball in hand anywhere.
#define CAROM_PLAY_FROM_ANYWHERE 9

// No rail, no pocket, no ball, no player.
#define CAROM_NONE -1

// At rest on the cloth.
#define CAROM_STATIONARY 0

// Spinning about the vertical without moving.
#define CAROM_SPINNING 1

// Rolling without slip.
#define CAROM_ROLLING 2

// Sliding on the cloth.
#define CAROM_SLIDING 3

// In the air.
#define CAROM_AIRBORNE 4

// In a pocket.
#define CAROM_POCKETED 5

// Off the table.
#define CAROM_OFF_TABLE 6

// The cue meets the cue ball.
#define CAROM_CUE_STRIKE 0

// Two balls collide, or several in one contact.
#define CAROM_BALL_COLLISION 1

// A ball meets a cushion.
#define CAROM_RAIL_COLLISION 2

// A ball falls into a pocket.
#define CAROM_POCKET_COLLISION 3

// A ball bounces on the slate.
#define CAROM_SLATE_COLLISION 4

// A ball leaves the table.
#define CAROM_LEFT_TABLE 5

// A motion ends by the passage of time.
#define CAROM_MOTION_TRANSITION 6

// y = 0.
#define CAROM_BOTTOM 0

// y = length.
#define CAROM_TOP 1

// x = width, of a table without side pockets.
#define CAROM_RIGHT 3

// x = 0, below the side pocket.
#define CAROM_LEFT_LOWER 4

// x = 0, above the side pocket.
#define CAROM_LEFT_UPPER 5

// x = width, below the side pocket.
#define CAROM_RIGHT_LOWER 6

// x = width, above the side pocket.
#define CAROM_RIGHT_UPPER 7

// The straight nose of a cushion.
#define CAROM_NOSE 0

// The straight side of a pocket's jaw.
#define CAROM_FACING 1

// The rounded corner between nose and facing.
#define CAROM_POINT 2

// The top of a rail.
#define CAROM_RAIL_TOP 3

// The wall of a pocket.
#define CAROM_LINER 4

// A shot ended with every ball at rest.
#define CAROM_END_REST 0

// A shot ended at its end time.
#define CAROM_END_UNTIL 1

// A shot ended at its cap of events.
#define CAROM_END_CAP 2

// Nothing is called.
#define CAROM_CALL_NOTHING 0

// A ball is called into a pocket.
#define CAROM_CALL_POCKET 1

// A safety.
#define CAROM_CALL_SAFETY 2

// A push-out.
#define CAROM_CALL_PUSH_OUT 3

// A ball is nominated as the ball on.
#define CAROM_CALL_ON 4

// The decision is a play.
#define CAROM_DECIDES_PLAY 0

// The decision is a choice.
#define CAROM_DECIDES_CHOICE 1

// The decision is to concede.
#define CAROM_DECIDES_CONCEDE 2

// The cue passes through no ball or rail, or the strike is refused.
#define CAROM_REFUSE_OBSTRUCTION 1

// A tip offset past the miscue limit is played as if the tip did not slip.
#define CAROM_REPORT_MISCUE 2

// Version of this header: 10000 major + 100 minor + patch. A program compares it with
// carom_version when it starts: the major and minor numbers must be equal.
#define CAROM_VERSION 100

// A game in progress, with its history. One thread uses it at a time; functions that only read it may
// run on several threads at once.
typedef struct carom_frame carom_frame;

// A built-in player; immutable. Any number of threads may use it at once.
typedef struct carom_player carom_player;

// A shot; immutable. Any number of threads may use it at once.
typedef struct carom_shot carom_shot;

// Plays one shot after another and keeps their memory. One thread uses it at a time.
typedef struct carom_sim carom_sim;

// A signal that ends decisions. Any number of threads may use it at once.
typedef struct carom_stop carom_stop;

// A table with its physics; immutable. Any number of threads may use it at once.
typedef struct carom_table carom_table;

// A simulated shot with all its events; immutable. Any number of threads may use it at once.
typedef struct carom_trace carom_trace;

// A strike of the cue. All zero but the speed: level unless that would touch a rail or a ball, along
// +x, at the ball's centre.
typedef struct carom_strike {
  // The cue's speed, m/s, above 0 and at most 50. 0 in a definition: there is no strike.
  double speed;
  // Direction in which the cue moves, rad, counter-clockwise from +x, seen from above.
  double azimuth;
  // The butt's angle above the horizontal, rad, from 0 to less than π/2; read if has_elevation is not 0.
  double elevation;
  // Offset of the contact point to the right, ball radii.
  double side;
  // Offset of the contact point upwards, ball radii.
  double height;
  // 0: the default elevation, the least at which the cue clears rails and balls. Else: elevation.
  int32_t has_elevation;
  // A sum of CAROM_REFUSE_OBSTRUCTION and CAROM_REPORT_MISCUE, or 0. A batch has that of its shot.
  int32_t policy;
} carom_strike;

// What a frame starts with. All zero: nine-ball with the usual options.
typedef struct carom_frame_def {
  // The game's name; null for "nine-ball".
  const char *game;
  // The name of a preset, or an object as JSON; null for the game's own table.
  const char *table;
  // The name of a preset, or an object as JSON; null for the physics of the table.
  const char *physics;
  // Seed of the racks.
  uint64_t seed;
  // Points that win, in games with a target; 0 for the default.
  int32_t points;
  // Not 0: no foul and a miss is called in snooker.
  int32_t no_miss;
  // Shots in a row without progress that make a stalemate; 0 for the default.
  uint32_t patience;
} carom_frame_def;

// What a frame asks for.
typedef struct carom_request {
  // CAROM_ASKS_SHOT, CAROM_ASKS_CHOICE or CAROM_OVER.
  int32_t kind;
  // Who has to answer, 0 or 1; CAROM_NONE when the frame is over.
  int32_t player;
  // Who has won; CAROM_NONE while the frame goes on, and if it ended undecided.
  int32_t winner;
  // Of a shot: the cue ball, an index of the frame's balls; else CAROM_NONE.
  int32_t cue_ball;
  // Of a shot with the cue ball in hand: CAROM_ANYWHERE to CAROM_THE_D; else CAROM_NONE.
  int32_t in_hand;
  // Of a shot: a sum of CAROM_MAY_CALL to CAROM_MUST_NOMINATE.
  int32_t calls;
  // Number of balls on.
  int32_t on_count;
  // The balls of which one must be hit first, on_count indices; none if any may be.
  int32_t on[22];
  // Number of choices.
  int32_t choice_count;
  // CAROM_PLAY_ON to CAROM_PLAY_FROM_ANYWHERE, choice_count of them.
  int32_t choices[10];
} carom_request;

// A player's shot. All zero but the strike: the cue ball is played from where it lies, without a call.
typedef struct carom_play {
  // The strike of the cue ball.
  struct carom_strike strike;
  // Centre of a cue ball in hand, m; read if has_cue_ball is not 0.
  double cue_ball[2];
  // Whether the cue ball is placed.
  int32_t has_cue_ball;
  // CAROM_CALL_NOTHING to CAROM_CALL_ON.
  int32_t call;
  // The ball of the call, an index of the frame's balls.
  int32_t call_ball;
  // The pocket of the call, an index of the table's pockets.
  int32_t call_pocket;
} carom_play;

// The referee's ruling on a move.
typedef struct carom_ruling {
  // 1 if there was no foul.
  int32_t legal;
  // Number of fouls; carom_frame_ruling_json names them.
  int32_t foul_count;
  // Change of each player's score.
  int32_t points[2];
  // Number of balls that were spotted.
  int32_t spotted_count;
  // 1 if balls were racked again.
  int32_t racked;
} carom_ruling;

// What a player may spend on a decision, and the errors of the strikes. All zero: 20 000 simulated
// shots or the number in the player's name, and the errors of the Computational Olympiad.
typedef struct carom_think_def {
  // Errors of the player's strikes: the name of a level such as "club", or JSON; null for those of
  // the player's level, or else the Olympiad's.
  const char *noise;
  // Errors of the opponent's strikes; null for those of the player.
  const char *opponent_noise;
  // Ends the decision after its present round when it is set; null for none.
  const struct carom_stop *stop;
  // Time of the decision, s; 0 for no limit.
  double time;
  // Seed of the random numbers.
  uint64_t seed;
  // Largest number of simulated shots; 0 for the default, or for none with a time or with rounds.
  uint64_t simulations;
  // Largest number of rounds of the search; 0 for no limit.
  uint32_t rounds;
  // Number of threads; 0 for one on each core. The decision does not depend on it.
  int32_t threads;
} carom_think_def;

// A player's decision.
typedef struct carom_decision {
  // The play, of CAROM_DECIDES_PLAY.
  struct carom_play play;
  // Probability with which the player expects to win the frame; NaN for players that do not
  // estimate it.
  double win_chance;
  // Number of simulated shots.
  uint64_t simulations;
  // Number of completed rounds. A decision with the same number of rounds is the same.
  uint32_t rounds;
  // CAROM_DECIDES_PLAY to CAROM_DECIDES_CONCEDE.
  int32_t kind;
  // The choice, of CAROM_DECIDES_CHOICE; else CAROM_NONE.
  int32_t choice;
  // 1 if the stop ended the decision.
  int32_t stopped;
} carom_decision;

// A ball of a shot.
typedef struct carom_ball {
  // Its unique name; null stands for its index.
  const char *id;
  // Centre, m; z 0 stands for a ball on the cloth.
  double position[3];
  // m/s
  double velocity[3];
  // Spin, rad/s.
  double angular_velocity[3];
  // kg; 0 stands for that of the physics.
  double mass;
  // m; 0 stands for that of the physics.
  double radius;
} carom_ball;

// What a shot is made of. All zero but balls and ball_count: no strike, until every ball is at rest.
typedef struct carom_shot_def {
  // The balls, ball_count of them.
  const struct carom_ball *balls;
  // Number of balls, at least 1.
  int32_t ball_count;
  // Index of the struck ball.
  int32_t struck;
  // The strike; with the speed 0 there is none, and the balls' velocities start the motion.
  struct carom_strike strike;
  // End time, s since the strike; 0: until every ball is at rest.
  double until;
  // Cap on the number of events; 0: 100 000.
  uint32_t max_events;
} carom_shot_def;

// The opening shot of a game. All zero: the break of nine-ball.
typedef struct carom_break_def {
  // The game's name; null for "nine-ball".
  const char *game;
  // The table preset's name; null for that of the game.
  const char *table;
  // A way of players to open the game, by name; null for a strike in the middle.
  const char *preset;
  // The cue's speed, m/s; 0: the usual one.
  double speed;
  // Seed of the gaps in the rack.
  uint64_t seed;
} carom_break_def;

// What a table is made of. All zero: a pool table of 9 ft with the physics of pool.
typedef struct carom_table_def {
  // The name of a preset, or the object "table" of a shot file as JSON; null for "wpa-9ft".
  const char *table;
  // The name of a preset, or the object "physics" of a shot file as JSON; null for the physics
  // that belongs to the table.
  const char *physics;
} carom_table_def;

// Size and pockets of a table.
typedef struct carom_table_size {
  // Along x between the nose lines, m; infinite for cloth without rails.
  double width;
  // Along y between the nose lines, m; infinite for cloth without rails.
  double length;
  // Height of the noses above the slate, m.
  double cushion_height;
  // Radius of a ball, m, unless a shot gives another.
  double ball_radius;
  // Mass of a ball, kg, unless a shot gives another.
  double ball_mass;
  // Number of pockets.
  int32_t pocket_count;
} carom_table_size;

// A pocket of a table.
typedef struct carom_pocket {
  // Centre of its hole, m.
  double center[2];
  // Radius of its hole, m.
  double radius;
} carom_pocket;

// The state of a ball at one instant.
typedef struct carom_state {
  // Centre, m: x along the table's width, y along its length, z up from the slate.
  double position[3];
  // m/s
  double velocity[3];
  // Spin, rad/s.
  double angular_velocity[3];
  // Rotation since the start of the shot: a unit quaternion x, y, z, w.
  double orientation[4];
  // CAROM_STATIONARY to CAROM_OFF_TABLE.
  int32_t motion;
} carom_state;

// An event of a trace. Its balls and points stand in the arrays of carom_events.
typedef struct carom_event {
  // Time since the strike, s.
  double time;
  // The largest impulse that a ball gets, N s: the strength of its sound. 0 if nothing meets.
  double strength;
  // CAROM_CUE_STRIKE to CAROM_MOTION_TRANSITION.
  int32_t kind;
  // Index of its first ball in carom_events.balls.
  int32_t first_ball;
  // Number of its balls.
  int32_t ball_count;
  // Index of its first point of contact in carom_events.points.
  int32_t first_point;
  // Number of its points of contact; in a strike that of the tip comes first.
  int32_t point_count;
  // CAROM_BOTTOM to CAROM_RIGHT_UPPER of a rail collision, or CAROM_NONE.
  int32_t rail;
  // CAROM_NOSE to CAROM_LINER of a rail collision, or CAROM_NONE.
  int32_t part;
  // Index of the pocket on the table that the ball falls into, or CAROM_NONE.
  int32_t pocket;
  // The motion that ends in a motion transition, or CAROM_NONE.
  int32_t from;
  // The motion that follows, or CAROM_NONE.
  int32_t to;
  // How often the tip met the cue ball in a strike; more than one contact is a double hit.
  int32_t tip_contacts;
  // 1 if the cue ball met another ball in the strike while the tip was on it.
  int32_t pushed;
} carom_event;

// A ball just before or just after an event.
typedef struct carom_motion {
  // Centre, m.
  double position[3];
  // m/s
  double velocity[3];
  // Spin, rad/s.
  double angular_velocity[3];
  // CAROM_STATIONARY to CAROM_OFF_TABLE.
  int32_t motion;
} carom_motion;

// A ball of an event.
typedef struct carom_event_ball {
  // What the ball gets in the impact, N s; zero if nothing meets.
  double impulse[3];
  // The ball just before.
  struct carom_motion before;
  // The ball just after.
  struct carom_motion after;
  // Its index in the shot.
  int32_t ball;
} carom_event_ball;

// The events of a trace. The arrays belong to the trace, and live as long.
typedef struct carom_events {
  // The events in order; null if there are none.
  const struct carom_event *events;
  // The balls of all events; null if there are none.
  const struct carom_event_ball *balls;
  // The points of contact, m: x, y, z of each; null if there are none.
  const double *points;
  // Number of events.
  int32_t event_count;
  // Number of entries in balls.
  int32_t ball_count;
  // Number of points; the array has three numbers for each.
  int32_t point_count;
} carom_events;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Simulates n shots, without traces. The results are the same for any number of threads.
//
// shots: n of them. balls: columns of a row, at least the balls of the largest shot. threads: 0 for one
// on each core, 1 for the calling thread.
// position: n × balls × 3 final centres, m, NaN where a shot has no such ball or failed. pocket:
// n × balls indices of pockets, or CAROM_ON_TABLE, CAROM_LEFT, CAROM_PADDING. events: n numbers of
// events. Any of the three may be null.
// Returns the number of shots that failed, with the text of the first failure; or a negative number
// with the text of the error.
// Ownership: the arrays belong to the caller, and are used in the call alone. Threads: any, if no
// two calls have the same arrays.
int32_t carom_batch(const struct carom_shot *const *shots,
                    size_t n,
                    int32_t balls,
                    int32_t threads,
                    double *position,
                    int8_t *pocket,
                    int32_t *events,
                    char *error,
                    int32_t error_size);

// Simulates a shot with n strikes on its struck ball, without traces.
//
// strikes: n of them. balls: columns of a row, at least the balls of the shot. The rest is as in
// carom_batch.
int32_t carom_batch_strikes(const struct carom_shot *shot,
                            const struct carom_strike *strikes,
                            size_t n,
                            int32_t balls,
                            int32_t threads,
                            double *position,
                            int8_t *pocket,
                            int32_t *events,
                            char *error,
                            int32_t error_size);

// A definition of a frame with default values.
//
// Threads: any.
struct carom_frame_def carom_default_frame_def(void);

// Racks a new frame.
//
// def: null stands for a definition with default values.
// Returns the frame, or null with the text of the error.
// Ownership: free it with carom_frame_free. What def points to is copied. Threads: any.
struct carom_frame *carom_frame_new(const struct carom_frame_def *def,
                                    char *error,
                                    int32_t error_size);

// A frame that starts from the balls of a shot, on its table, with its physics. In games in which each
// player has a cue ball, the player whose cue ball the shot strikes begins; otherwise player 0.
//
// def: table, physics and seed are not read; null stands for a definition with default values.
// Returns the frame, or null with the text of the error.
// Ownership: free it with carom_frame_free; the shot stays. Threads: any.
struct carom_frame *carom_frame_of_shot(const struct carom_frame_def *def,
                                        const struct carom_shot *shot,
                                        char *error,
                                        int32_t error_size);

// The frame of a record, carom-frame/1, with every move repeated: a saved game.
//
// Returns the frame, or null with the text of the error.
// Ownership: free it with carom_frame_free. The text is read in the call. Threads: any.
struct carom_frame *carom_frame_from_json(const char *json, char *error, int32_t error_size);

// The record of a frame, carom-frame/1: its start and all its moves. Python and JavaScript read it too.
//
// Returns the text, or null for a null pointer.
// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
char *carom_frame_to_json(const struct carom_frame *frame);

// The last move, JSON on one line, as carom_frame_move takes it: what two programs in lockstep send.
//
// Returns the text, or null before the first move.
// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
char *carom_frame_last_move_json(const struct carom_frame *frame);

// An independent copy of a frame.
//
// Returns the copy, or null for a null pointer.
// Ownership: free it with carom_frame_free. Threads: any, while none changes the frame.
struct carom_frame *carom_frame_copy(const struct carom_frame *frame);

// The hash over everything that decides how the frame goes on. The same version of the engine gives
// the same value in every language and on every platform.
//
// Returns the hash, or 0 for a null pointer.
// Threads: any, while none changes the frame.
uint64_t carom_frame_hash(const struct carom_frame *frame);

// Game, request, scores and balls of a frame, JSON.
//
// Returns the text, or null for a null pointer.
// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
char *carom_frame_state_json(const struct carom_frame *frame);

// The last ruling with its fouls in words and the rules that they break, JSON.
//
// Returns the text, or null before the first move after the start or the reading of a record.
// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
char *carom_frame_ruling_json(const struct carom_frame *frame);

// Writes what the frame asks for into out.
//
// Returns 0, or a negative number for a null pointer.
// Threads: any, while none changes the frame.
int32_t carom_frame_request(const struct carom_frame *frame, struct carom_request *out);

// Number of balls of a frame, on the table or not.
//
// Returns the number, or a negative number for a null pointer.
// Threads: any.
int32_t carom_frame_ball_count(const struct carom_frame *frame);

// The id of ball number ball.
//
// Returns the id, or null if there is no such ball.
// Ownership: the text belongs to the frame, and lives as long. Threads: any.
const char *carom_frame_ball_id(const struct carom_frame *frame, int32_t ball);

// Writes the centre (x and y, m) of ball number ball into out, room for two numbers.
//
// Returns 1 if the ball is on the table, 0 if it is not; or a negative number if there is no such
// ball.
// Threads: any, while none changes the frame.
int32_t carom_frame_ball_place(const struct carom_frame *frame, int32_t ball, double (*out)[2]);

// The shot that a play would be, to draw or to simulate; the frame stays as it is.
//
// Returns the shot, or null with the text of the error. Its balls are those on the table, in the order
// of the frame.
// Ownership: free it with carom_shot_free. Threads: any, while none changes the frame.
struct carom_shot *carom_frame_shot(const struct carom_frame *frame,
                                    const struct carom_play *play,
                                    char *error,
                                    int32_t error_size);

// Plays a shot, and rules on it.
//
// ruling and trace may be null. A trace that is wanted is written into trace; null on failure.
// Returns 0, or a negative number with the text of the error; the frame stays as it was then.
// Ownership: free the trace with carom_trace_free. Threads: one at a time for each frame.
int32_t carom_frame_play(struct carom_frame *frame,
                         const struct carom_play *play,
                         struct carom_ruling *ruling,
                         struct carom_trace **trace,
                         char *error,
                         int32_t error_size);

// Makes a move in the form of a record, JSON: {"play": {"strike": {...}}}, {"choice": "play-on"} or
// {"concede": true}.
//
// ruling and trace may be null. A trace that is wanted is written into trace; null on failure, and
// for a move that is not a play.
// Returns 0, or a negative number with the text of the error; the frame stays as it was then.
// Ownership: free the trace with carom_trace_free. Threads: one at a time for each frame.
int32_t carom_frame_move(struct carom_frame *frame,
                         const char *json,
                         struct carom_ruling *ruling,
                         struct carom_trace **trace,
                         char *error,
                         int32_t error_size);

// Answers the choice that the frame asks for.
//
// choice: the choice's number, one of those in carom_request. ruling may be null.
// Returns 0, or a negative number with the text of the error; the frame stays as it was then.
// Threads: one at a time for each frame.
int32_t carom_frame_choose(struct carom_frame *frame,
                           int32_t choice,
                           struct carom_ruling *ruling,
                           char *error,
                           int32_t error_size);

// The player whose turn it is concedes.
//
// ruling may be null.
// Returns 0, or a negative number with the text of the error.
// Threads: one at a time for each frame.
int32_t carom_frame_concede(struct carom_frame *frame,
                            struct carom_ruling *ruling,
                            char *error,
                            int32_t error_size);

// Why the frame asks for a choice, or why it is over, in words.
//
// Returns the text, or null if the frame asks for a shot.
// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
char *carom_frame_why(const struct carom_frame *frame);

// Frees a frame; null is passed over.
//
// Ownership: the pointer must not be used afterwards, nor the ids of its balls. Threads: any.
void carom_frame_free(struct carom_frame *frame);

// A play with default values, without a strike.
//
// Threads: any.
struct carom_play carom_default_play_def(void);

// A budget with default values.
//
// Threads: any.
struct carom_think_def carom_default_think_def(void);

// Makes a player.
//
// name: "carom", a level such as "level-3", or a player of the literature; a number of simulated shots
// may follow, as in "carom:2000". Null stands for "carom".
// Returns the player, or null with the text of the error.
// Ownership: free it with carom_player_free. Threads: any.
struct carom_player *carom_player_new(const char *name,
                                      char *error,
                                      int32_t error_size);

// Lets a player think about the request of a frame, and writes its answer into out.
//
// def: null stands for a budget with default values. The frame stays as it is.
// Returns 0, or a negative number with the text of the error.
// Threads: any, while none changes the frame. The call lasts as long as the budget; another thread may
// end it with carom_stop_set. Players of the literature have one round, which nothing ends.
int32_t carom_player_decide(const struct carom_player *player,
                            const struct carom_frame *frame,
                            const struct carom_think_def *def,
                            struct carom_decision *out,
                            char *error,
                            int32_t error_size);

// The play that comes out when a player with errors intends one, written into out.
//
// noise: the name of a level, or JSON. seed: that of the frame's errors; each shot has its own.
// Returns 0, or a negative number with the text of the error.
// A noise with cling is refused: a carom_play has no place for it.
// Threads: any, while none changes the frame.
int32_t carom_frame_draw(const struct carom_frame *frame,
                         const struct carom_play *play,
                         const char *noise,
                         uint64_t seed,
                         struct carom_play *out,
                         char *error,
                         int32_t error_size);

// Makes a signal that ends decisions, not set.
//
// Ownership: free it with carom_stop_free, after the decisions that use it. Threads: any.
struct carom_stop *carom_stop_new(void);

// Sets a signal (set is not 0) or takes it back (0). Null is passed over.
//
// Threads: any, also while a decision uses the signal.
void carom_stop_set(const struct carom_stop *stop, int32_t set);

// Frees a signal; null is passed over.
//
// Ownership: the pointer must not be used afterwards. Threads: any.
void carom_stop_free(struct carom_stop *stop);

// Frees a player; null is passed over.
//
// Ownership: the pointer must not be used afterwards. Threads: any.
void carom_player_free(struct carom_player *player);

// A strike with default values: none.
//
// Threads: any.
struct carom_strike carom_default_strike_def(void);

// A definition of a shot with default values, without balls.
//
// Threads: any.
struct carom_shot_def carom_default_shot_def(void);

// A definition of an opening shot with default values.
//
// Threads: any.
struct carom_break_def carom_default_break_def(void);

// Makes a shot on a table.
//
// Returns the shot, or null with the text of the error.
// Ownership: free it with carom_shot_free. What def points to is copied. Threads: any.
struct carom_shot *carom_shot_new(const struct carom_table *table,
                                  const struct carom_shot_def *def,
                                  char *error,
                                  int32_t error_size);

// Reads a shot file, carom-shot/1.
//
// Returns the shot, or null with the text of the error.
// Ownership: free it with carom_shot_free. The text is read in the call. Threads: any.
struct carom_shot *carom_shot_from_json(const char *json, char *error, int32_t error_size);

// The opening shot of a game.
//
// def: null stands for a definition with default values.
// Returns the shot, or null with the text of the error.
// Ownership: free it with carom_shot_free. Threads: any.
struct carom_shot *carom_break_shot(const struct carom_break_def *def,
                                    char *error,
                                    int32_t error_size);

// The same shot with another strike on the same ball. The policy of the strike is not read.
//
// Returns the shot, or null with the text of the error.
// Ownership: free it with carom_shot_free; the first shot stays. Threads: any.
struct carom_shot *carom_shot_with_strike(const struct carom_shot *shot,
                                          const struct carom_strike *strike,
                                          char *error,
                                          int32_t error_size);

// The shot file as JSON, with the elevation that is used; it reads back to the same bits.
//
// Returns the text, or null for a null pointer.
// Ownership: free the text with carom_text_free. Threads: any.
char *carom_shot_to_json(const struct carom_shot *shot);

// The table and the physics of a shot.
//
// Returns the table, or null for a null pointer.
// Ownership: free it with carom_table_free. Threads: any.
struct carom_table *carom_shot_table(const struct carom_shot *shot);

// Number of balls.
//
// Returns the number, or a negative number for a null pointer.
// Threads: any.
int32_t carom_shot_ball_count(const struct carom_shot *shot);

// Writes ball number ball, at the start of the shot, into out.
//
// Returns 0, or a negative number if there is no such ball.
// Ownership: out->id belongs to the shot, and lives as long. Threads: any.
int32_t carom_shot_ball(const struct carom_shot *shot, int32_t ball, struct carom_ball *out);

// The index of the ball with this id.
//
// Returns the index, or a negative number if there is none.
// Threads: any.
int32_t carom_shot_ball_index(const struct carom_shot *shot, const char *id);

// Writes the strike, with its elevation, into out.
//
// Returns the index of the struck ball, or CAROM_NONE if the shot has no strike.
// Threads: any.
int32_t carom_shot_strike(const struct carom_shot *shot, struct carom_strike *out);

// Frees a shot; null is passed over.
//
// Ownership: the pointer must not be used afterwards. Threads: any.
void carom_shot_free(struct carom_shot *shot);

// Which kinds of fault an error may name, JSON: a list of objects with "kind" and "sentence".
//
// Ownership: free the text with carom_text_free. Threads: any.
char *carom_error_kinds_json(void);

// Makes a simulator, for one thread.
//
// Ownership: free it with carom_sim_free. Threads: any.
struct carom_sim *carom_sim_new(void);

// Simulates a shot and records all its events.
//
// Returns the trace, or null with the text of the error.
// Ownership: the trace belongs to the simulator. It, and the arrays of its events, are valid until the
// next call of this function or of carom_sim_free. Threads: one at a time for each simulator.
const struct carom_trace *carom_sim_play(struct carom_sim *sim,
                                         const struct carom_shot *shot,
                                         char *error,
                                         int32_t error_size);

// Frees a simulator; null is passed over.
//
// Ownership: the pointer must not be used afterwards, nor its trace. Threads: any.
void carom_sim_free(struct carom_sim *sim);

// A definition of a table with default values.
//
// Threads: any.
struct carom_table_def carom_default_table_def(void);

// Makes a table.
//
// def: null stands for a definition with default values; its texts are read in the call.
// Returns the table, or null with the text of the error.
// Ownership: free it with carom_table_free; shots on it keep what they need. Threads: any.
struct carom_table *carom_table_new(const struct carom_table_def *def,
                                    char *error,
                                    int32_t error_size);

// Frees a table; null is passed over.
//
// Ownership: the pointer must not be used afterwards. Threads: any.
void carom_table_free(struct carom_table *table);

// Writes the size of a table into out.
//
// Returns 0, or a negative number for a null pointer.
// Threads: any.
int32_t carom_table_get_size(const struct carom_table *table, struct carom_table_size *out);

// Writes pocket number pocket of a table into out. Batches, events and calls have the same numbers.
//
// Returns 0, or a negative number if there is no such pocket.
// Threads: any.
int32_t carom_table_get_pocket(const struct carom_table *table,
                               int32_t pocket,
                               struct carom_pocket *out);

// The geometry of a table, JSON: noses, facings, points, pockets, spots.
//
// Returns the text, or null for a null pointer.
// Ownership: free the text with carom_text_free. Threads: any.
char *carom_table_geometry_json(const struct carom_table *table);

// All values of the physics of a table, JSON, as a shot file has them.
//
// Returns the text, or null for a null pointer.
// Ownership: free the text with carom_text_free. Threads: any.
char *carom_table_physics_json(const struct carom_table *table);

// Frees a text that a function of carom gave to the caller; null is passed over.
//
// Ownership: the text must not be used afterwards. Threads: any.
void carom_text_free(char *text);

// The names of all presets, JSON: lists under the keys "tables", "physics", "games", "noises" and
// "players".
//
// Ownership: free the text with carom_text_free. Threads: any.
char *carom_presets_json(void);

// Simulates a shot and records all its events.
//
// Returns the trace, or null with the text of the error.
// Ownership: free it with carom_trace_free; it keeps what it needs of the shot. Threads: any. A
// thread that plays many shots is faster with a carom_sim.
struct carom_trace *carom_shot_simulate(const struct carom_shot *shot,
                                        char *error,
                                        int32_t error_size);

// Writes the exact state of a ball at a time into out.
//
// ball: index in the shot. time: s since the strike, 0 or more; after the end it is the final state.
// Returns 0, or a negative number for a wrong index or time.
// Threads: any.
int32_t carom_trace_state(const struct carom_trace *trace,
                          int32_t ball,
                          double time,
                          struct carom_state *out);

// Writes the exact states of all balls at a time into out.
//
// time: as in carom_trace_state. out: room for count states; count is the number of balls.
// Returns 0, or a negative number for a wrong time or count.
// Threads: any.
int32_t carom_trace_states(const struct carom_trace *trace,
                           double time,
                           struct carom_state *out,
                           int32_t count);

// Writes the arrays of the events into out.
//
// Returns the number of events, or a negative number for a null pointer.
// Ownership: the arrays belong to the trace, and live as long. Threads: any.
int32_t carom_trace_events(const struct carom_trace *trace, struct carom_events *out);

// Writes points of the path of a ball into out: x, y, z (m) and t (s) of each. The chords between
// them stay within the tolerance of the exact path.
//
// tolerance: m, above 0. out: room for count points, four numbers each; null with count 0 to ask for
// their number.
// Returns the number of points of the path, which may be more than count; or a negative number.
// Threads: any.
int32_t carom_trace_path(const struct carom_trace *trace,
                         int32_t ball,
                         double tolerance,
                         double *out,
                         int32_t count);

// Time from the strike to the end, s.
//
// Returns the time, or NaN for a null pointer.
// Threads: any.
double carom_trace_duration(const struct carom_trace *trace);

// What ended the shot.
//
// Returns CAROM_END_REST, CAROM_END_UNTIL or CAROM_END_CAP, or a negative number for a null pointer.
// Threads: any.
int32_t carom_trace_end(const struct carom_trace *trace);

// The hash over the exact bits of all events and final states. It is the same in every language and
// on every platform.
//
// Returns the hash, or 0 for a null pointer.
// Threads: any.
uint64_t carom_trace_hash(const struct carom_trace *trace);

// The outcome for a referee, JSON: the first contact, the pocketed balls and more.
//
// Returns the text, or null for a null pointer.
// Ownership: free the text with carom_text_free. Threads: any.
char *carom_trace_outcome_json(const struct carom_trace *trace);

// The trace as JSON, carom-trace/1.
//
// Returns the text, or null for a null pointer.
// Ownership: free the text with carom_text_free. Threads: any.
char *carom_trace_to_json(const struct carom_trace *trace);

// Reads a trace, carom-trace/1.
//
// Returns the trace, or null with the text of the error.
// Ownership: free it with carom_trace_free. The text is read in the call. Threads: any.
struct carom_trace *carom_trace_from_json(const char *json, char *error, int32_t error_size);

// The shot of a trace.
//
// Returns the shot, or null for a null pointer.
// Ownership: free it with carom_shot_free. Threads: any.
struct carom_shot *carom_trace_shot(const struct carom_trace *trace);

// Frees a trace; null is passed over.
//
// Ownership: the pointer must not be used afterwards, nor the arrays of its events. Threads: any.
void carom_trace_free(struct carom_trace *trace);

// The version of the library that runs, in the form of CAROM_VERSION.
//
// Threads: any.
int32_t carom_version(void);

// Name and version of the engine, as traces and records have them, such as "carom 0.1.0".
//
// Ownership: the text belongs to the library and is never freed. Threads: any.
const char *carom_engine(void);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CAROM_H */
