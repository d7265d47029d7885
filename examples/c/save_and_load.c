/* Saves a game to a file and loads it: the record holds the start and every move, so the loaded frame
 * has the same bits, and the same hash. Python and JavaScript read the file too.
 *
 *     save_and_load GAME.json   writes the file
 */
#include <carom.h>
#include <stdio.h>
#include <stdlib.h>

static void stop(const char *what)
{
    fprintf(stderr, "%s\n", what);
    exit(1);
}

int main(int argc, char **argv)
{
    static char text[1 << 20];
    char error[512];
    if (argc != 2) {
        stop("usage: save_and_load GAME.json");
    }
    carom_frame_def def = carom_default_frame_def();
    def.game = "eight-ball";
    def.seed = 11;
    carom_frame *frame = carom_frame_new(&def, error, sizeof error);
    if (!frame) {
        stop(error);
    }
    carom_play opening = carom_default_play_def();
    opening.strike.speed = 8.0;
    opening.strike.azimuth = 1.5707963267948966; /* up the table */
    opening.has_cue_ball = 1;
    opening.cue_ball[0] = 0.635;
    opening.cue_ball[1] = 0.6;
    carom_ruling ruling;
    if (carom_frame_play(frame, &opening, &ruling, NULL, error, sizeof error) < 0) {
        stop(error);
    }
    char *record = carom_frame_to_json(frame);
    FILE *file = fopen(argv[1], "wb");
    if (!file || fputs(record, file) < 0 || fclose(file) != 0) {
        stop("the file cannot be written");
    }
    carom_text_free(record);

    file = fopen(argv[1], "rb");
    if (!file) {
        stop("the file cannot be read");
    }
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    carom_frame *loaded = carom_frame_from_json(text, error, sizeof error);
    if (!loaded) {
        stop(error);
    }
    int same = carom_frame_hash(frame) == carom_frame_hash(loaded);
    printf("%s break, %s after loading\n", ruling.legal ? "legal" : "foul",
           same ? "the same hash" : "ANOTHER HASH");
    carom_frame_free(loaded);
    carom_frame_free(frame);
    return same ? 0 : 1;
}
