// What the window in a page asks of its browser (page_events.h), as a library of emscripten's.
addToLibrary({
  page_is_there: () => typeof document === 'undefined' ? 0 : 1,

  page_show_cursor: (name) => {
    document.getElementById('canvas').style.cursor = UTF8ToString(name);
  },

  page_copy: (text) => {
    navigator.clipboard?.writeText(UTF8ToString(text)).catch(() => {});
  },

  page_listen__deps: ['$FS', '$stringToNewUTF8', 'free'],
  page_listen: () => {
    const give = (take, text) => {
      const bytes = stringToNewUTF8(text);
      take(bytes);
      _free(bytes);
    };
    addEventListener('paste', (event) => {
      give(Module['_page_pasted'], event.clipboardData.getData('text/plain'));
      event.preventDefault();
    });
    addEventListener('contextmenu', (event) => event.preventDefault());
    addEventListener('dragover', (event) => event.preventDefault());
    addEventListener('drop', async (event) => {
      event.preventDefault();
      const folder = '/dropped';
      const files = [...event.dataTransfer.files];
      if (!FS.analyzePath(folder).exists) FS.mkdir(folder);
      for (const file of files) {
        FS.writeFile(folder + '/' + file.name, new Uint8Array(await file.arrayBuffer()));
      }
      give(Module['_page_dropped'], files.map((file) => folder + '/' + file.name).join('\n'));
    });
  },
});
