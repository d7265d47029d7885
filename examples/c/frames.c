/* Plays a shot frame by frame at 60 Hz, as a game's loop does. Every picture shows exact states: a slow
 * picture skips time and adds no error. Between two pictures it plays the sounds of the impacts.
 *
 *     frames [SHOT.json]        without a file: a nine-ball break
 */
#include <carom.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double STEP = 1.0 / 60.0;  /* s */
static const double AUDIBLE = 0.005;    /* N s: below it no sound is played */

/* The whole text of a file; free it with free(). */
static char *read_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        return NULL;
    }
    size_t length = 0, room = 1 << 16;
    char *text = malloc(room);
    while (text) {
        length += fread(text + length, 1, room - length - 1, file);
        if (length < room - 1) {
            text[length] = '\0';
            break;
        }
        char *more = realloc(text, room *= 2);
        if (!more) {
            free(text);
        }
        text = more;
    }
    fclose(file);
    return text;
}

static carom_shot *open_shot(const char *path, char *error, int32_t size)
{
    if (!path) {
        carom_break_def opening = carom_default_break_def();
        opening.seed = 20;
        return carom_break_shot(&opening, error, size);
    }
    char *text = read_file(path);
    if (!text) {
        snprintf(error, (size_t)size, "%s cannot be read", path);
        return NULL;
    }
    carom_shot *shot = carom_shot_from_json(text, error, size);
    free(text);
    return shot;
}

/* A game plays a sample here, as loud as the impulse and at the point of contact. */
static void play_sounds(const carom_events *events, int32_t *next, double until)
{
    static const char *const names[] = {"cue", "click", "cushion", "pocket", "slate"};
    for (; *next < events->event_count && events->events[*next].time <= until; ++*next) {
        const carom_event *event = &events->events[*next];
        if (event->kind == CAROM_POCKET_COLLISION) {
            printf("  sound pocket %d\n", event->pocket);
        } else if (event->strength > AUDIBLE) {
            const double *point = events->points + 3 * event->first_point;
            printf("  sound %s %.3f N s at %.2f %.2f\n", names[event->kind], event->strength,
                   point[0], point[1]);
        }
    }
}

/* A game sets the transforms of its models here. */
static void draw(const carom_shot *shot, const carom_state *states, int32_t count, long frame)
{
    printf("frame %ld:", frame);
    for (int32_t i = 0; i < count; ++i) {
        carom_ball ball;
        int moves = states[i].motion != CAROM_STATIONARY && states[i].motion < CAROM_POCKETED;
        if (moves && carom_shot_ball(shot, i, &ball) == 0) {
            const double *at = states[i].position, *turn = states[i].orientation;
            printf("  %s (%.3f %.3f %.3f) turned %.0f deg", ball.id, at[0], at[1], at[2],
                   2.0 * acos(fmin(1.0, fabs(turn[3]))) * 57.29577951308232);
        }
    }
    putchar('\n');
}

int main(int argc, char **argv)
{
    char error[512];
    if (carom_version() / 100 != CAROM_VERSION / 100) {
        fprintf(stderr, "the library is %d, the header %d\n", carom_version(), CAROM_VERSION);
        return 1;
    }
    carom_shot *shot = open_shot(argc > 1 ? argv[1] : NULL, error, sizeof error);
    if (!shot) {
        fprintf(stderr, "%s\n", error);
        return 2;
    }
    carom_trace *trace = carom_shot_simulate(shot, error, sizeof error);
    int32_t balls = carom_shot_ball_count(shot);
    carom_state *states = malloc((size_t)balls * sizeof *states);
    carom_events events;
    if (!trace || !states || carom_trace_events(trace, &events) < 0) {
        fprintf(stderr, "%s\n", error);
        return 2;
    }
    int32_t next_sound = 0;
    for (long frame = 0;; ++frame) {
        double time = (double)frame * STEP; /* or the clock of the game */
        play_sounds(&events, &next_sound, time);
        if (carom_trace_states(trace, time, states, balls) < 0) {
            return 1;
        }
        draw(shot, states, balls, frame);
        if (time > carom_trace_duration(trace)) {
            break;
        }
    }
    printf("%.3f s, hash %016llx\n", carom_trace_duration(trace),
           (unsigned long long)carom_trace_hash(trace));
    free(states);
    carom_trace_free(trace);
    carom_shot_free(shot);
    return 0;
}
