/* Uses every function of the interface, rightly and wrongly. */
#include <carom.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(condition) check(condition, #condition, __LINE__)

static char error[512];

static void check(int holds, const char *condition, int line)
{
    if (!holds) {
        fprintf(stderr, "line %d: %s does not hold; error: %s\n", line, condition, error);
        exit(1);
    }
}

/* Whether the text of the error has kind and place. */
static int refused(const char *kind, const char *place)
{
    char start[128];
    snprintf(start, sizeof start, "[%s] %s", kind, place);
    return strncmp(error, start, strlen(start)) == 0 && strchr(error, ';') != NULL;
}

static carom_ball ball(const char *id, double x, double y)
{
    carom_ball made;
    memset(&made, 0, sizeof made);
    made.id = id;
    made.position[0] = x;
    made.position[1] = y;
    return made;
}

static carom_shot *two_balls(const carom_table *table, double speed)
{
    carom_ball balls[2] = {ball("cue", 0.45, 0.75), ball("8", 0.80, 1.45)};
    carom_shot_def def = carom_default_shot_def();
    def.balls = balls;
    def.ball_count = 2;
    def.strike.speed = speed;
    def.strike.azimuth = 62.92 * 3.14159265358979323846 / 180.0;
    return carom_shot_new(table, &def, error, sizeof error);
}

static void versions_and_lists(void)
{
    CHECK(carom_version() == CAROM_VERSION);
    CHECK(strncmp(carom_engine(), "carom ", 6) == 0);
    char *presets = carom_presets_json(), *kinds = carom_error_kinds_json();
    CHECK(strstr(presets, "\"wpa-9ft\"") && strstr(presets, "\"nine-ball\"") &&
          strstr(presets, "\"club\"") && strstr(presets, "\"level-3\""));
    CHECK(strstr(kinds, "\"out-of-range\"") != NULL);
    carom_text_free(presets);
    carom_text_free(kinds);
    carom_text_free(NULL);
}

static void tables(void)
{
    carom_table_def def = carom_default_table_def();
    carom_table *usual = carom_table_new(NULL, error, sizeof error);
    def.table = "{\"length\": 2.0, \"width\": 1.0, \"pockets\": \"none\"}";
    def.physics = "{\"base\": \"pool\", \"gravity\": 1.62}";
    carom_table *moon = carom_table_new(&def, error, sizeof error);
    CHECK(usual && moon && error[0] == '\0');
    carom_table_size size;
    CHECK(carom_table_get_size(moon, &size) == 0);
    CHECK(size.length == 2.0 && size.width == 1.0 && size.pocket_count == 0);
    CHECK(carom_table_get_size(usual, &size) == 0 && size.pocket_count == 6);
    CHECK(size.ball_radius > 0.02 && size.ball_radius < 0.03 && size.ball_mass > 0.1);
    carom_pocket pocket;
    CHECK(carom_table_get_pocket(usual, 5, &pocket) == 0 && pocket.radius > 0.03);
    CHECK(pocket.center[0] > size.width - 0.2 && pocket.center[1] > size.length - 0.2);
    CHECK(carom_table_get_pocket(usual, 6, &pocket) == CAROM_REFUSED);
    CHECK(carom_table_get_pocket(usual, -1, &pocket) == CAROM_REFUSED);
    CHECK(carom_table_get_size(NULL, &size) == CAROM_REFUSED);
    CHECK(carom_table_get_size(usual, NULL) == CAROM_REFUSED);
    char *json = carom_table_geometry_json(usual), *physics = carom_table_physics_json(moon);
    CHECK(strstr(json, "\"pockets\"") && strstr(physics, "1.62"));
    carom_text_free(json);
    carom_text_free(physics);
    def.table = "wpa-10ft";
    CHECK(!carom_table_new(&def, error, sizeof error) && refused("unknown-name", "table"));
    def.table = "{";
    CHECK(!carom_table_new(&def, error, sizeof error) && error[0] == '[');
    def.table = "\xff";
    CHECK(!carom_table_new(&def, error, sizeof error) && refused("syntax", "def.table"));
    carom_table_free(usual);
    carom_table_free(moon);
    carom_table_free(NULL);
}

static void shots(void)
{
    carom_table *table = carom_table_new(NULL, error, sizeof error);
    carom_shot *shot = two_balls(table, 1.84);
    carom_table_free(table); /* the shot keeps what it needs */
    CHECK(shot && carom_shot_ball_count(shot) == 2);
    carom_ball placed;
    CHECK(carom_shot_ball(shot, 1, &placed) == 0 && strcmp(placed.id, "8") == 0);
    CHECK(placed.position[2] == placed.radius && placed.mass > 0.0);
    CHECK(carom_shot_ball_index(shot, "8") == 1 && carom_shot_ball_index(shot, "9") == CAROM_NONE);
    carom_strike strike;
    CHECK(carom_shot_strike(shot, &strike) == 0 && strike.speed == 1.84 && strike.has_elevation);
    CHECK(strike.elevation > 0.0); /* the default: a real stroke's */
    strike.elevation = 0.0;
    carom_shot *level = carom_shot_with_strike(shot, &strike, error, sizeof error);
    CHECK(carom_shot_strike(level, &strike) == 0 && strike.elevation == 0.0);
    strike.has_elevation = 0;
    carom_shot *usual = carom_shot_with_strike(level, &strike, error, sizeof error);
    CHECK(carom_shot_strike(usual, &strike) == 0 && strike.elevation > 0.0);
    strike.side = 0.9;
    CHECK(!carom_shot_with_strike(shot, &strike, error, sizeof error) && refused("miscue", "strike"));
    strike.side = NAN;
    CHECK(!carom_shot_with_strike(shot, &strike, error, sizeof error) &&
          refused("out-of-range", "strike.side"));
    carom_table *again = carom_shot_table(shot);
    carom_shot *same = two_balls(again, 1.84);
    char *one = carom_shot_to_json(shot), *other = carom_shot_to_json(same);
    CHECK(strcmp(one, other) == 0);
    CHECK(!two_balls(again, -1.0) && refused("out-of-range", "strike.speed"));
    CHECK(!two_balls(NULL, 1.0) && refused("missing", "table"));
    CHECK(!carom_shot_new(again, NULL, error, sizeof error) && refused("missing", "def"));
    carom_shot_def def = carom_default_shot_def();
    CHECK(!carom_shot_new(again, &def, error, sizeof error) && refused("ball-count", "balls"));
    carom_ball overlapping[2] = {ball(NULL, 0.5, 0.5), ball(NULL, 0.51, 0.5)};
    def.balls = overlapping;
    def.ball_count = 2;
    CHECK(!carom_shot_new(again, &def, error, sizeof error) && refused("overlap", "balls[1]"));
    overlapping[1].position[0] = 1.0;
    overlapping[1].velocity[1] = 1.0;
    def.until = 0.25;
    carom_shot *moving = carom_shot_new(again, &def, error, sizeof error);
    CHECK(carom_shot_strike(moving, &strike) == CAROM_NONE);
    carom_trace *trace = carom_shot_simulate(moving, error, sizeof error);
    CHECK(carom_trace_end(trace) == CAROM_END_UNTIL && carom_trace_duration(trace) == 0.25);
    def.until = 0.0;
    def.max_events = 1;
    carom_shot *capped = carom_shot_new(again, &def, error, sizeof error);
    CHECK(capped && !carom_shot_simulate(capped, error, sizeof error) &&
          refused("too-many-events", "max_events"));
    CHECK(!carom_shot_from_json("{\"format\": 1}", error, sizeof error) && error[0] == '[');
    CHECK(!carom_shot_from_json(NULL, error, sizeof error) && refused("missing", "json"));
    char tiny[8];
    CHECK(!carom_shot_from_json(NULL, tiny, sizeof tiny) && strcmp(tiny, "[missin") == 0);
    CHECK(!carom_shot_from_json(NULL, NULL, 0));
    CHECK(carom_shot_ball_count(NULL) == CAROM_REFUSED && !carom_shot_to_json(NULL));
    CHECK(carom_shot_ball(shot, 2, &placed) == CAROM_REFUSED && !carom_shot_table(NULL));
    carom_text_free(one);
    carom_text_free(other);
    carom_trace_free(trace);
    carom_table_free(again);
    carom_shot_free(same);
    carom_shot_free(capped);
    carom_shot_free(moving);
    carom_shot_free(usual);
    carom_shot_free(level);
    carom_shot_free(shot);
    carom_shot_free(NULL);
}

static void traces(void)
{
    carom_break_def def = carom_default_break_def();
    def.game = "eight-ball";
    def.seed = 3;
    def.speed = 9.0;
    carom_shot *shot = carom_break_shot(&def, error, sizeof error);
    carom_trace *trace = carom_shot_simulate(shot, error, sizeof error);
    carom_events events;
    CHECK(trace && carom_trace_events(trace, &events) == events.event_count);
    CHECK(events.events[0].kind == CAROM_CUE_STRIKE && events.events[0].strength > 1.0);
    int32_t balls = 0, points = 0, kinds[7] = {0};
    double last = 0.0;
    for (int32_t k = 0; k < events.event_count; ++k) {
        const carom_event *event = &events.events[k];
        CHECK(event->time >= last && event->kind >= 0 && event->kind <= CAROM_MOTION_TRANSITION);
        CHECK(event->first_ball == balls && event->first_point == points);
        CHECK((event->kind == CAROM_RAIL_COLLISION) == (event->rail != CAROM_NONE));
        CHECK((event->kind == CAROM_POCKET_COLLISION) == (event->pocket != CAROM_NONE));
        CHECK((event->kind == CAROM_MOTION_TRANSITION) == (event->from != CAROM_NONE));
        double strongest = 0.0;
        for (int32_t b = 0; b < event->ball_count; ++b) {
            const double *j = events.balls[balls + b].impulse;
            strongest = fmax(strongest, sqrt(j[0] * j[0] + j[1] * j[1] + j[2] * j[2]));
        }
        CHECK(fabs(strongest - event->strength) < 1e-12);
        ++kinds[event->kind];
        last = event->time;
        balls += event->ball_count;
        points += event->point_count;
    }
    CHECK(balls == events.ball_count && points == events.point_count);
    CHECK(kinds[CAROM_BALL_COLLISION] > 10 && kinds[CAROM_RAIL_COLLISION] > 5);
    CHECK(carom_trace_end(trace) == CAROM_END_REST);
    /* The state at the time of an event is that just after it. */
    const carom_event *hit = &events.events[events.event_count / 2];
    const carom_event_ball *after = &events.balls[hit->first_ball];
    carom_state state;
    CHECK(carom_trace_state(trace, after->ball, hit->time, &state) == 0);
    CHECK(memcmp(state.velocity, after->after.velocity, sizeof state.velocity) == 0);
    CHECK(carom_trace_state(trace, 99, 0.0, &state) == CAROM_REFUSED);
    CHECK(carom_trace_state(trace, 0, -1.0, &state) == CAROM_REFUSED);
    CHECK(carom_trace_state(trace, 0, NAN, &state) == CAROM_REFUSED);
    CHECK(carom_trace_states(trace, 0.0, &state, 1) == CAROM_REFUSED);
    CHECK(carom_trace_states(trace, 0.0, NULL, 16) == CAROM_REFUSED);
    int32_t needed = carom_trace_path(trace, 0, 1e-3, NULL, 0);
    double *path = malloc((size_t)needed * 4 * sizeof *path);
    CHECK(needed > 2 && carom_trace_path(trace, 0, 1e-3, path, needed) == needed);
    CHECK(path[3] == 0.0 && path[4 * needed - 1] > 0.1);
    CHECK(carom_trace_path(trace, 0, 0.0, path, needed) == CAROM_REFUSED);
    free(path);
    char *outcome = carom_trace_outcome_json(trace);
    CHECK(strstr(outcome, "\"first_contact\"") != NULL);
    carom_text_free(outcome);
    CHECK(carom_trace_hash(NULL) == 0 && isnan(carom_trace_duration(NULL)));
    CHECK(!carom_trace_from_json("[]", error, sizeof error) && error[0] == '[');
    carom_shot *own = carom_trace_shot(trace);
    CHECK(carom_shot_ball_count(own) == 16);
    def.game = "croquet";
    CHECK(!carom_break_shot(&def, error, sizeof error) && strncmp(error, "[unknown-name] ", 15) == 0);
    carom_shot_free(own);
    carom_trace_free(trace);
    carom_trace_free(NULL);
    carom_shot_free(shot);
}

static void batches(void)
{
    enum { N = 300, BALLS = 3 };
    static double position[2][N * BALLS * 3];
    static int8_t pocket[2][N * BALLS];
    static int32_t events[2][N];
    static carom_strike strikes[N];
    carom_table *table = carom_table_new(NULL, error, sizeof error);
    carom_shot *shot = two_balls(table, 1.84);
    const carom_shot *shots[N];
    for (int k = 0; k < N; ++k) {
        strikes[k] = carom_default_strike_def();
        strikes[k].speed = k == 17 ? -1.0 : 1.84;
        strikes[k].azimuth = 1.05 + 2e-4 * k;
        carom_strike own = strikes[k];
        own.speed = 1.84;
        shots[k] = carom_shot_with_strike(shot, &own, error, sizeof error);
        CHECK(shots[k] != NULL);
    }
    CHECK(carom_batch_strikes(shot, strikes, N, BALLS, 1, position[0], pocket[0], events[0], error,
                              sizeof error) == 1);
    CHECK(refused("out-of-range", "[17].strike.speed"));
    CHECK(events[0][17] == 0 && isnan(position[0][17 * BALLS * 3]) && pocket[0][17 * BALLS] == -3);
    CHECK(carom_batch(shots, N, BALLS, 2, position[1], pocket[1], events[1], error, sizeof error) == 0);
    int potted = 0;
    for (int k = 0; k < N; ++k) {
        CHECK(pocket[1][k * BALLS + 2] == CAROM_PADDING && isnan(position[1][(k * BALLS + 2) * 3]));
        potted += pocket[1][k * BALLS + 1] >= 0;
        if (k != 17) {
            CHECK(events[0][k] == events[1][k]);
            CHECK(memcmp(position[0] + k * BALLS * 3, position[1] + k * BALLS * 3, 6 * 8) == 0);
            CHECK(memcmp(pocket[0] + k * BALLS, pocket[1] + k * BALLS, BALLS) == 0);
        }
    }
    CHECK(potted > 10 && potted < N);
    CHECK(carom_batch(shots, N, BALLS, 0, NULL, NULL, events[0], error, sizeof error) == 0);
    CHECK(memcmp(events[0], events[1], sizeof events[0]) == 0);
    CHECK(carom_batch(NULL, 0, BALLS, 1, NULL, NULL, NULL, error, sizeof error) == 0);
    CHECK(carom_batch(shots, N, 1, 1, NULL, NULL, NULL, error, sizeof error) == CAROM_REFUSED);
    CHECK(refused("wrong-count", "balls"));
    CHECK(carom_batch(shots, N, -1, 1, NULL, NULL, NULL, error, sizeof error) == CAROM_REFUSED);
    CHECK(carom_batch(shots, N, BALLS, -1, NULL, NULL, NULL, error, sizeof error) == CAROM_REFUSED);
    CHECK(refused("out-of-range", "threads"));
    CHECK(carom_batch(shots, (size_t)-1, 3, 1, NULL, NULL, NULL, error, sizeof error) == CAROM_REFUSED);
    CHECK(carom_batch(NULL, 3, 3, 1, NULL, NULL, NULL, error, sizeof error) == CAROM_REFUSED);
    CHECK(carom_batch_strikes(shot, NULL, 3, 3, 1, NULL, NULL, NULL, error, sizeof error) ==
          CAROM_REFUSED);
    for (int k = 0; k < N; ++k) {
        carom_shot_free((carom_shot *)shots[k]);
    }
    carom_shot_free(shot);
    carom_table_free(table);
}

static void frames(void)
{
    carom_frame_def def = carom_default_frame_def();
    def.seed = 7;
    carom_frame *frame = carom_frame_new(&def, error, sizeof error);
    carom_request request;
    CHECK(frame && carom_frame_request(frame, &request) == 0);
    CHECK(request.kind == CAROM_ASKS_SHOT && request.player == 0 && request.cue_ball == 0);
    CHECK(request.in_hand == CAROM_BEHIND_HEAD_STRING && request.on_count == 1 && request.on[0] == 1);
    CHECK(carom_frame_ball_count(frame) == 10 && strcmp(carom_frame_ball_id(frame, 0), "cue") == 0);
    CHECK(!carom_frame_ball_id(frame, 10) && !carom_frame_last_move_json(frame));
    CHECK(!carom_frame_ruling_json(frame) && !carom_frame_why(frame));
    double place[2];
    CHECK(carom_frame_ball_place(frame, 1, (double(*)[2])place) == 1 && place[1] > 1.5);
    carom_play play = carom_default_play_def();
    play.strike.speed = 8.0;
    play.strike.azimuth = 1.5707963267948966;
    uint64_t start = carom_frame_hash(frame);
    carom_trace *trace = (carom_trace *)&play; /* not an object: it must not be freed */
    play.strike.side = 2.0;
    CHECK(carom_frame_play(frame, &play, NULL, &trace, error, sizeof error) == CAROM_REFUSED);
    CHECK(refused("out-of-range", "strike.side") && !trace);
    play.strike.side = 0.0;
    CHECK(carom_frame_hash(frame) == start);
    play.has_cue_ball = 1;
    play.cue_ball[0] = 0.635;
    play.cue_ball[1] = 2.0;
    CHECK(carom_frame_play(frame, &play, NULL, &trace, error, sizeof error) == CAROM_REFUSED);
    CHECK(refused("outside-region", "cue_ball") && !trace);
    play.cue_ball[1] = 0.6;
    play.call = 9;
    CHECK(!carom_frame_shot(frame, &play, error, sizeof error) && refused("unknown-name", "call"));
    play.call = CAROM_CALL_NOTHING;
    carom_shot *preview = carom_frame_shot(frame, &play, error, sizeof error);
    CHECK(carom_shot_ball_count(preview) == 10);
    carom_ruling ruling;
    CHECK(carom_frame_play(frame, &play, &ruling, &trace, error, sizeof error) == 0);
    carom_trace *drawn = carom_shot_simulate(preview, error, sizeof error);
    CHECK(carom_trace_hash(drawn) == carom_trace_hash(trace));
    CHECK(ruling.legal == (ruling.foul_count == 0) && ruling.points[0] == 0);
    char *words = carom_frame_ruling_json(frame), *state = carom_frame_state_json(frame);
    CHECK(strstr(words, "\"legal\"") && strstr(state, "\"nine-ball\""));
    /* The other computer of a game in lockstep. */
    carom_frame *there = carom_frame_new(&def, error, sizeof error);
    char *move = carom_frame_last_move_json(frame);
    CHECK(carom_frame_hash(there) == start && strchr(move, '\n') == NULL);
    CHECK(carom_frame_move(there, move, NULL, NULL, error, sizeof error) == 0);
    CHECK(carom_frame_hash(there) == carom_frame_hash(frame));
    /* Save and load. */
    char *record = carom_frame_to_json(frame);
    carom_frame *loaded = carom_frame_from_json(record, error, sizeof error);
    carom_frame *copy = carom_frame_copy(loaded);
    CHECK(carom_frame_hash(loaded) == carom_frame_hash(frame));
    CHECK(carom_frame_concede(copy, &ruling, error, sizeof error) == 0);
    CHECK(carom_frame_request(copy, &request) == 0 && request.kind == CAROM_OVER);
    CHECK(request.player == CAROM_NONE && request.winner >= 0 && request.winner <= 1);
    char *why = carom_frame_why(copy);
    CHECK(strcmp(why, "the other player conceded") == 0);
    CHECK(carom_frame_hash(copy) != carom_frame_hash(loaded));
    CHECK(carom_frame_concede(copy, NULL, error, sizeof error) == CAROM_REFUSED);
    CHECK(refused("frame-over", "concede"));
    CHECK(carom_frame_choose(loaded, 0, NULL, error, sizeof error) == CAROM_REFUSED);
    CHECK(carom_frame_choose(loaded, 99, NULL, error, sizeof error) == CAROM_REFUSED);
    CHECK(carom_frame_move(loaded, "{\"choice\": \"dance\"}", NULL, NULL, error, sizeof error) < 0);
    CHECK(refused("unknown-name", "choice"));
    CHECK(carom_frame_move(loaded, "{}", NULL, NULL, error, sizeof error) < 0);
    CHECK(!carom_frame_from_json("{\"format\": \"carom-shot/1\"}", error, sizeof error));
    CHECK(refused("format", "format"));
    carom_shot *opening = carom_break_shot(NULL, error, sizeof error);
    carom_frame *of_shot = carom_frame_of_shot(NULL, opening, error, sizeof error);
    CHECK(of_shot && carom_frame_request(of_shot, &request) == 0 && request.in_hand == CAROM_NONE);
    carom_shot_free(opening);
    carom_text_free(why);
    carom_text_free(record);
    carom_text_free(move);
    carom_text_free(words);
    carom_text_free(state);
    carom_trace_free(drawn);
    carom_trace_free(trace);
    carom_shot_free(preview);
    carom_frame_free(of_shot);
    carom_frame_free(there);
    carom_frame_free(copy);
    carom_frame_free(loaded);
    carom_frame_free(frame);
    carom_frame_free(NULL);
}

struct thought {
    const carom_player *player;
    const carom_frame *frame;
    carom_think_def budget;
    carom_decision decision;
    int32_t result;
};

static void *think(void *given)
{
    struct thought *thought = given;
    thought->result = carom_player_decide(thought->player, thought->frame, &thought->budget,
                                          &thought->decision, NULL, 0);
    return NULL;
}

static void players(void)
{
    carom_player *player = carom_player_new("carom:400", error, sizeof error);
    carom_frame *frame = carom_frame_new(NULL, error, sizeof error);
    carom_think_def budget = carom_default_think_def();
    budget.noise = "club";
    budget.threads = 1;
    carom_decision one, other;
    CHECK(carom_player_decide(player, frame, &budget, &one, error, sizeof error) == 0);
    budget.threads = 2;
    CHECK(carom_player_decide(player, frame, &budget, &other, error, sizeof error) == 0);
    CHECK(one.kind == CAROM_DECIDES_PLAY && one.rounds > 0 && one.stopped == 0);
    CHECK(memcmp(&one.play.strike, &other.play.strike, 5 * sizeof(double)) == 0);
    CHECK(one.win_chance >= 0.0 && one.win_chance <= 1.0 && one.simulations <= 400 + 4000);
    carom_play played, again;
    CHECK(carom_frame_draw(frame, &one.play, "club", 5, &played, error, sizeof error) == 0);
    CHECK(carom_frame_draw(frame, &one.play, "club", 5, &again, error, sizeof error) == 0);
    CHECK(played.strike.azimuth == again.strike.azimuth);
    CHECK(played.strike.azimuth != one.play.strike.azimuth);
    CHECK(carom_frame_draw(frame, &one.play, "god", 5, &again, error, sizeof error) == CAROM_REFUSED);
    CHECK(refused("unknown-name", "noise"));
    CHECK(carom_frame_play(frame, &played, NULL, NULL, error, sizeof error) == 0);
    /* Another thread ends a decision that would take an hour. */
    carom_player *slow = carom_player_new(NULL, error, sizeof error);
    carom_stop *stop = carom_stop_new();
    struct thought thought = {slow, frame, carom_default_think_def(), one, 1};
    thought.budget.time = 3600.0;
    thought.budget.threads = 1;
    thought.budget.stop = stop;
    pthread_t thread;
    CHECK(pthread_create(&thread, NULL, think, &thought) == 0);
    carom_stop_set(stop, 1);
    CHECK(pthread_join(thread, NULL) == 0);
    CHECK(thought.result == 0 && thought.decision.stopped == 1 && thought.decision.rounds > 0);
    budget.time = -1.0;
    CHECK(carom_player_decide(slow, frame, &budget, &one, error, sizeof error) == CAROM_REFUSED);
    CHECK(refused("out-of-range", "def.time"));
    CHECK(!carom_player_new("nobody", error, sizeof error) && refused("unknown-name", "player"));
    carom_stop_set(NULL, 1);
    carom_stop_free(stop);
    carom_stop_free(NULL);
    carom_player_free(slow);
    carom_player_free(player);
    carom_player_free(NULL);
    carom_frame_free(frame);
}

int main(void)
{
    versions_and_lists();
    tables();
    shots();
    traces();
    batches();
    frames();
    players();
    carom_sim *sim = carom_sim_new();
    CHECK(!carom_sim_play(sim, NULL, error, sizeof error) && refused("missing", "shot"));
    carom_sim_free(sim);
    carom_sim_free(NULL);
    puts("everything holds");
    return 0;
}
