// The sound of a page, for audio_host_web.cpp: Web Audio asks for it on the page's own thread, in pieces.
addToLibrary({
  $webSound: {
    context: null,
    open: {},  // node and memory, by number
    last: 0,
    // A browser lets a page sound after a press or a key, some only during one.
    wake: () => {
      if (Object.keys(webSound.open).length > 0 && webSound.context.state !== 'running') webSound.context.resume();
    },
  },

  web_sound_open__deps: ['$webSound', 'malloc', 'web_sound_render'],
  web_sound_open: (sound, channels, rate_hz, frames) => {
    if (typeof AudioContext === 'undefined') return 0;
    if (!webSound.context) {
      webSound.context = new AudioContext({sampleRate: rate_hz});
      for (const kind of ['pointerdown', 'pointerup', 'keydown']) addEventListener(kind, webSound.wake, true);
    }
    const context = webSound.context;
    const node = context.createScriptProcessor(frames, 0, channels);
    const memory = _malloc(4 * frames * channels);
    node.onaudioprocess = (event) => {
      const late_s = event.playbackTime - context.currentTime + (context.outputLatency || 0);
      _web_sound_render(sound, memory, frames, late_s);
      for (let channel = 0; channel < channels; ++channel) {
        const samples = event.outputBuffer.getChannelData(channel);
        for (let k = 0; k < frames; ++k) samples[k] = HEAPF32[(memory >> 2) + k * channels + channel];
      }
    };
    node.connect(context.destination);
    webSound.open[++webSound.last] = {node, memory};
    webSound.wake();
    return webSound.last;
  },

  web_sound_close__deps: ['$webSound', 'free'],
  web_sound_close: (number) => {
    const {node, memory} = webSound.open[number];
    delete webSound.open[number];
    node.onaudioprocess = null;
    node.disconnect();
    // Not while its last piece may still be copied.
    setTimeout(() => _free(memory), 0);
    if (Object.keys(webSound.open).length === 0) webSound.context.suspend();
  },
});
