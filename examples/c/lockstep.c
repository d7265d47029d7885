/* Lockstep multiplayer: two processes play one game of nine-ball. They exchange only their moves, each
 * with the hash of the frame after it, and compare the hashes. For POSIX: a socket pair stands for the
 * network.
 *
 *     lockstep [SEED]
 */
#define _POSIX_C_SOURCE 200809L
#include <carom.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_MOVES = 200, LINE = 1 << 16 };

static void fail(const char *what)
{
    fprintf(stderr, "lockstep: %s\n", what);
    exit(1);
}

/* This side answers the request, with the errors of its own hand: they are drawn once, here. */
static void answer(carom_frame *frame, const carom_player *player, uint64_t seed)
{
    char error[512];
    carom_think_def budget = carom_default_think_def();
    budget.noise = "club";
    budget.simulations = 300;
    budget.threads = 1;
    carom_decision decision;
    if (carom_player_decide(player, frame, &budget, &decision, error, sizeof error) < 0) {
        fail(error);
    }
    int32_t done;
    if (decision.kind == CAROM_DECIDES_PLAY) {
        carom_play play;
        done = carom_frame_draw(frame, &decision.play, "club", seed, &play, error, sizeof error);
        if (done == 0) {
            done = carom_frame_play(frame, &play, NULL, NULL, error, sizeof error);
        }
    } else if (decision.kind == CAROM_DECIDES_CHOICE) {
        done = carom_frame_choose(frame, decision.choice, NULL, error, sizeof error);
    } else {
        done = carom_frame_concede(frame, NULL, error, sizeof error);
    }
    if (done < 0) {
        fail(error);
    }
}

/* Sends the move that was just made: the hash and the move on one line. */
static void send_move(FILE *out, const carom_frame *frame)
{
    char *move = carom_frame_last_move_json(frame);
    if (fprintf(out, "%016" PRIx64 " %s\n", carom_frame_hash(frame), move) < 0 || fflush(out) != 0) {
        fail("the other side is gone");
    }
    carom_text_free(move);
}

/* Makes the move that the other side sent, and compares the frames. */
static void receive_move(FILE *in, carom_frame *frame, char *line)
{
    char error[512];
    uint64_t hash;
    int move_at = 0;
    if (!fgets(line, LINE, in) || sscanf(line, "%" SCNx64 " %n", &hash, &move_at) != 1) {
        fail("the other side is gone");
    }
    if (carom_frame_move(frame, line + move_at, NULL, NULL, error, sizeof error) < 0) {
        fail(error); /* a move that the rules refuse: a fault of the other side, or a cheat */
    }
    if (carom_frame_hash(frame) != hash) {
        char *record = carom_frame_to_json(frame);
        fprintf(stderr, "the frames differ; the record on this side:\n%s\n", record);
        exit(1);
    }
}

static void play(int32_t side, int channel, uint64_t seed)
{
    char error[512];
    carom_frame_def def = carom_default_frame_def();
    def.seed = seed; /* both sides agree on game, table, options and seed before they start */
    carom_frame *frame = carom_frame_new(&def, error, sizeof error);
    carom_player *player = frame ? carom_player_new(NULL, error, sizeof error) : NULL;
    FILE *in = fdopen(channel, "r"), *out = fdopen(dup(channel), "w");
    char *line = malloc(LINE);
    if (!frame || !player || !in || !out || !line) {
        fail(frame && player ? "no memory" : error);
    }
    carom_request request;
    int moves = 0;
    for (; moves < MOST_MOVES; ++moves) {
        carom_frame_request(frame, &request);
        if (request.kind == CAROM_OVER) {
            break;
        }
        if (request.player == side) {
            answer(frame, player, seed + (uint64_t)side);
            send_move(out, frame);
        } else {
            receive_move(in, frame, line);
        }
    }
    printf("side %d: winner %d after %d moves, hash %016" PRIx64 "\n", side, request.winner, moves,
           carom_frame_hash(frame));
    fclose(in);
    fclose(out);
    free(line);
    carom_player_free(player);
    carom_frame_free(frame);
}

int main(int argc, char **argv)
{
    int ends[2], status;
    uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 7;
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        fail("no socket");
    }
    pid_t other = fork();
    if (other < 0) {
        fail("no process");
    }
    close(ends[other == 0 ? 0 : 1]);
    play(other == 0 ? 1 : 0, ends[other == 0 ? 1 : 0], seed);
    if (other == 0) {
        return 0;
    }
    return waitpid(other, &status, 0) == other && WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
